#include "couple/conforming_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/position_text.hpp"
#include "couple/interface_corner.hpp"
#include "couple/match_line_ends.hpp"
#include "couple/periodic_nodes.hpp"
#include "couple/side_pairs.hpp"
#include "curve/arc_length.hpp"
#include "quantize/quantize_and_extend.hpp"

namespace quadrille::couple {
namespace {

[[noreturn]] void fail_to_continue(const CadFace& face) {
  if (!face.periodic_pairs.empty())
    throw ComputeError(
        "the lines of the layout cannot be continued across the periodic sides: a strip of blocks winds onto itself; "
        "cut the repeated shape so that its periodic sides end at right angles, or leave out a pair (cad2tri "
        "--periodic)");
  if (face.num_regions() > 1)
    throw ComputeError(
        "the lines of the regions cannot be continued across their interfaces: a strip of blocks winds onto itself; "
        "mesh the regions alone (cad2tri --face)");
  std::string remedy;
  if (const auto corner = sharpest_interface_corner(face))
    remedy =
        fmt::format(", round the corner of the curve at {}, where it turns by {:.0f} degrees",
                    rounded_position_text(face.joints[corner->joint].position + face.origin), degrees(corner->turn));
  throw ComputeError(
      "the lines on both sides of an embedded curve cannot be continued across: a strip of blocks winds onto itself; "
      "choose other nodes (critpoints --nodes, --topology)" +
      remedy + ", or leave the curve out");
}

// Where the ends of an arc are along the first side; no value if the arc is not on it.
std::optional<std::array<double, 2>> positions_on(const CadFace& face, const SidePair& pair, const GraphArc& arc) {
  std::array<double, 2> positions{};
  for (const int side : {0, 1}) {
    const ArcPiece& piece = side == 0 ? arc.pieces.front() : arc.pieces.back();
    const std::vector<int>& curves = pair.curves[0];
    const auto found = std::find(curves.begin(), curves.end(), piece.curve);
    if (!arc.is_boundary || found == curves.end()) return std::nullopt;
    positions[side] = pair.offsets[found - curves.begin()] +
                      curve::ArcLength(face.curves[piece.curve]).at(side == 0 ? piece.t0 : piece.t1);
  }
  return positions;
}

// The nodes of both sides of which one is at `low` and the other at `high`, and that can be moved.
std::vector<NodeMatch> matches_between(const SidePair& pair, double low, double high, double same) {
  std::vector<NodeMatch> matches;
  const auto &firsts = pair.nodes[0], &seconds = pair.nodes[1];
  for (int i = 0; i < static_cast<int>(firsts.size()); ++i)
    for (int j = 0; j < static_cast<int>(seconds.size()); ++j) {
      const SideNode &a = firsts[i], &b = seconds[j];
      if (std::abs(std::min(a.position, b.position) - low) <= same &&
          std::abs(std::max(a.position, b.position) - high) <= same && (a.is_movable || b.is_movable))
        matches.push_back({{i, j}, (low + high) / 2});
    }
  return matches;
}

// Line ends on both sides between which every integer grid has no length, the nearest; equally near ones together.
std::vector<NodeMatch> forced_matches(const ArcGraph& t_mesh, const SidePair& pair, const std::vector<int>& zero_arcs) {
  std::vector<std::pair<double, NodeMatch>> found;
  double least = std::numeric_limits<double>::infinity();
  for (const int a : zero_arcs) {
    const auto ends = positions_on(t_mesh.face, pair, t_mesh.arcs[a]);
    if (!ends) continue;
    const auto [low, high] = *ends;
    for (const NodeMatch& match : matches_between(pair, low, high, relative_same * t_mesh.face.diameter)) {
      found.push_back({high - low, match});
      least = std::min(least, high - low);
    }
  }
  std::vector<NodeMatch> matches;
  for (const auto& [length, match] : found)
    if (length <= least * (1 + relative_tie)) matches.push_back(match);
  return matches;
}

/// The layout of the whole while its line ends on periodic sides are matched.
class PeriodicMatching {
 public:
  PeriodicMatching(const RegionLayouts& regions, graph::CandidateLayout joined)
      : whole_{regions.face, {}, regions.fields, {0}, regions.rotations} {
    whole_.layouts.push_back(std::move(joined));
    num_matched_ = match_line_ends(whole_, periodic_sides(whole_));
  }

  int num_matched() const { return num_matched_; }
  int num_divided() const { return num_divided_; }

  /// The layout divided on each side where the other one has a node.
  graph::CandidateLayout t_mesh() {
    graph::CandidateLayout divided = whole_.layouts.front();
    num_divided_ = divide_periodic_sides(divided);
    return divided;
  }

  /// Throws ComputeError unless matches leave fewer T-junctions.
  graph::CandidateLayout with_forced_matches(const quantize::InfeasibleTMesh& failed) {
    if (num_divided_ >= num_before_) fail_to_continue(whole_.face);
    num_before_ = num_divided_;
    const std::vector<SidePair> pairs = periodic_sides(whole_);
    const std::vector<int> zero_arcs = pairs.empty() ? std::vector<int>{} : failed.zero_arcs();
    const int num_forced = match_line_ends(
        whole_, pairs, [&](const SidePair& pair) { return forced_matches(failed.t_mesh.graph(), pair, zero_arcs); });
    if (num_forced == 0) fail_to_continue(whole_.face);
    num_matched_ += num_forced;
    return t_mesh();
  }

 private:
  RegionLayouts whole_;  // one layout, of all regions
  int num_matched_ = 0, num_divided_ = 0;
  int num_before_ = std::numeric_limits<int>::max();  // divided in the T-mesh that failed before
};

}  // namespace

graph::CandidateLayout conforming_layout(const RegionLayouts& regions, graph::CandidateLayout joined, Report& report) {
  PeriodicMatching matching(regions, std::move(joined));
  graph::CandidateLayout layout = matching.t_mesh();
  if (matching.num_divided() > 0 || !layout.t_junctions.empty())
    layout = quantize::quantize_and_extend(
                 std::move(layout), quantize::PeriodicSides::glued,
                 [&](const quantize::InfeasibleTMesh& failed) { return matching.with_forced_matches(failed); },
                 report.progress())
                 .layout;
  if (!regions.face.periodic_pairs.empty()) {
    report.set("couple.periodic_lines_met", matching.num_matched());
    report.set("couple.periodic_t_junctions", matching.num_divided());
  }
  return layout;
}

}  // namespace quadrille::couple
