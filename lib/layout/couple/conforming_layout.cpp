#include "couple/conforming_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/tolerance.hpp"
#include "couple/join_layouts.hpp"
#include "couple/side_pairs.hpp"
#include "curve/chain.hpp"
#include "curve/nurbs.hpp"
#include "graph/arc_pieces.hpp"
#include "model/periodic.hpp"
#include "quantize/quantize_and_extend.hpp"
#include "surface/positions.hpp"

namespace quadrille::couple {
namespace {

constexpr double least_turn = radians(45.0);

/// Whether an embedded curve passes the joint: not its end, where it turns back along its other side.
bool is_inside_curve(const CadFace& face, int joint) {
  const int before = face.previous_in_loop(joint);
  return face.is_interface(joint) && face.is_interface(before) && face.partners[joint] != before;
}

// A node inside a curve and the boundary arcs beside it.
void move_node(SeparatrixGraph& graph, int node, const BoundaryPoint& point) {
  GraphNode& n = graph.nodes[node];
  for (GraphArc& arc : graph.arcs) {
    if (!arc.is_boundary) continue;
    ArcPiece &first = arc.pieces.front(), &last = arc.pieces.back();
    if (arc.from == node && first.curve == point.curve) first.t0 = point.t;
    if (arc.to == node && last.curve == point.curve) last.t1 = point.t;
  }
  n.t = point.t;
  n.position = point.position(graph.face);
}

// Divides the boundary arc that runs through a point. Returns false where a node is.
bool divide_at(graph::CandidateLayout& layout, int curve, double t) {
  const ArcGraph& whole = layout.graph();
  const Nurbs& c = whole.face.curves[curve];
  for (int a = 0; a < static_cast<int>(whole.arcs.size()); ++a) {
    const std::vector<ArcPiece>& pieces = whole.arcs[a].pieces;
    if (!whole.arcs[a].is_boundary) continue;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (pieces[i].curve != curve) continue;
      const bool is_start = is_same_parameter(c, t, pieces[i].t0), is_end = is_same_parameter(c, t, pieces[i].t1);
      if ((is_start && i == 0) || (is_end && i + 1 == pieces.size())) return false;
      if (!is_start && !is_end && (t <= pieces[i].t0 || t >= pieces[i].t1)) continue;
      graph::divide_at_point(layout.subdivision, {a}, graph::point_on_piece(whole, pieces, i, t));
      return true;
    }
  }
  return false;
}

// The parameters of the ends of boundary arcs on a curve.
std::vector<double> node_parameters(const ArcGraph& graph, int curve) {
  std::vector<double> parameters;
  for (const GraphArc& arc : graph.arcs) {
    if (!arc.is_boundary) continue;
    if (arc.pieces.front().curve == curve) parameters.push_back(arc.pieces.front().t0);
    if (arc.pieces.back().curve == curve) parameters.push_back(arc.pieces.back().t1);
  }
  return parameters;
}

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
                    surface::rounded_position_text(face, face.joints[corner->joint].position), degrees(corner->turn));
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
    if (length <= least * (1 + tolerance::tied)) matches.push_back(match);
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

std::optional<InterfaceCorner> sharpest_interface_corner(const CadFace& face) {
  std::optional<InterfaceCorner> sharpest;
  double most = least_turn;
  for (int j = 0; j < face.num_curves(); ++j) {
    const double turn = std::abs(face.joints[j].interior_angle - pi);
    if (!is_inside_curve(face, j) || turn <= most + tolerance::same_angle) continue;
    most = turn;
    sharpest = {j, turn};
  }
  return sharpest;
}

void snap_periodic_nodes(SeparatrixGraph& graph) {
  const CadFace& face = graph.face;
  for (const PeriodicPair& pair : face.periodic_pairs) {
    const auto [a, b] = pair.curves;
    for (int n = 0; n < static_cast<int>(graph.nodes.size()); ++n) {
      const GraphNode& node = graph.nodes[n];
      if (node.curve != b || node.t == face.curves[b].begin()) continue;
      for (const GraphNode& other : graph.nodes) {
        if (other.curve != a || other.t == face.curves[a].begin()) continue;
        const BoundaryPoint image{b, periodic_parameter(face, a, other.t, b)};
        if (distance(image.position(face), node.position) > relative_same * face.diameter) continue;
        move_node(graph, n, image);
        break;
      }
    }
  }
  close_lines(graph);
}

int divide_periodic_sides(graph::CandidateLayout& layout) {
  int num_divided = 0;
  for (const SidePair& pair : periodic_sides({layout.graph().face, {}, {}, {}})) {
    const CadFace& face = layout.graph().face;
    const int first = pair.curves[0].front(), last = pair.curves[0].back();
    num_divided += divide_at(layout, first, face.curves[first].begin());
    num_divided += divide_at(layout, last, face.curves[last].end());
  }
  const std::vector<PeriodicPair> pairs = layout.graph().face.periodic_pairs;
  for (const PeriodicPair& pair : pairs)
    for (const int side : {0, 1}) {
      const int own = pair.curves[side], other = pair.curves[1 - side];
      for (const double t : node_parameters(layout.graph(), own))
        num_divided += divide_at(layout, other, periodic_parameter(layout.graph().face, own, t, other));
    }
  return num_divided;
}

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
