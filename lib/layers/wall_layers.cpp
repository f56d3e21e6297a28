#include "layers/wall_layers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "base/error.hpp"
#include "layers/arc_neighbours.hpp"
#include "layers/chord_layers.hpp"
#include "layers/column.hpp"
#include "layers/layer_fit.hpp"
#include "layers/layer_law.hpp"
#include "sizing/interval_error.hpp"
#include "sizing/name_joints.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::layers {
namespace {

/// Neighbours that differ by more are made to grow into each other.
constexpr double greatest_jump = 1.3;
constexpr int size_samples = 32;
constexpr int max_sweeps = 12;
constexpr int max_tolerance_rounds = 30;
constexpr double shrink = 0.8;
constexpr double equal_tol = 1e-6;
constexpr double same_fraction = 1e-9;

class WallPlanner {
 public:
  WallPlanner(const WallInput& input, sizing::ArcDivisions& divisions)
      : in_(input), divisions_(divisions), wishes_(input.measured.num_arcs()) {
    for (int arc = 0; arc < in_.measured.num_arcs(); ++arc) arc_sizes_.push_back(mean_size(in_.measured.chain(arc)));
  }

  WallPlan plan() {
    plan_.walls = find_wall_sides(layout(), in_.measured.curves(), curve_walls(in_.specs, layout().face), in_.specs);
    probes_ = probe_columns(in_.measured, plan_.walls, arc_sizes_);
    for (const int count : fitting_layers(in_.specs, probes_, layout().face.origin))
      plan_.heights.push_back(layer_heights(in_.specs[plan_.heights.size()], count));
    wish_for_layers();
    grade();
    place_nodes();
    find_shared();
    return std::move(plan_);
  }

 private:
  const BlockLayout& layout() const { return in_.measured.blocks(); }
  int chord_of(int arc) const { return in_.measured.chord_of(arc); }

  /// The harmonic mean of the wanted sizes along an arc: that which fits most of them in.
  double mean_size(const curve::Chain& chain) const {
    if (in_.sizes.is_uniform()) return in_.sizes.greatest();
    double sum = 0;
    for (int k = 0; k < size_samples; ++k) sum += 1 / in_.sizes.at(chain.at((k + 0.5) / size_samples).position);
    return size_samples / sum;
  }

  double length(int arc) const { return in_.measured.length(arc); }

  ColumnCurve from_end(int arc, int end) const {
    const curve::Chain& chain = in_.measured.chain(arc);
    return [&chain, end](double u) { return chain.at(end == 0 ? u : 1 - u).position; };
  }

  /// Shares of the arc's length from its end at which its nodes in the layers lie.
  std::vector<double> layer_nodes(int arc, int end) const {
    const WallSide& wall = plan_.walls.sides[plan_.walls.at_arc_end[arc][end]];
    const HalfEdge before = layout().block2arcs[wall.block][(wall.side + 3) % 4];
    const bool at_begin = before.arc == arc && 1 - beginning_of(before) == end;
    const std::vector<double> heights = node_heights(plan_.heights[wall.spec], in_.order);
    std::vector<double> nodes =
        parameters_at_heights(from_end(arc, end), wall.line, at_begin ? wall.begin : wall.end, heights);
    if (nodes.size() < heights.size()) {
      const Vec2 place = from_end(arc, end)(0) + layout().face.origin;
      throw ComputeError(
          fmt::format("the line between blocks that leaves the wall at ({:.6g}, {:.6g}) turns back "
                      "before the layers end",
                      place.x, place.y));
    }
    return nodes;
  }

  void wish_for_layers() {
    node_shares_.resize(wishes_.size());
    for (std::size_t arc = 0; arc < wishes_.size(); ++arc)
      for (const int end : {0, 1}) {
        const int wall = plan_.walls.at_arc_end[arc][end];
        if (wall < 0) continue;
        std::vector<double>& nodes = node_shares_[arc][end] = layer_nodes(static_cast<int>(arc), end);
        ArcEndWish& wish = wishes_[arc][end];
        for (std::size_t k = in_.order - 1; k < nodes.size(); k += in_.order) wish.cuts.push_back(nodes[k]);
        const double below = wish.cuts.size() > 1 ? wish.cuts[wish.cuts.size() - 2] : 0;
        wish.before = (wish.cuts.back() - below) * length(static_cast<int>(arc));
        wish.growth = growth_beyond(in_.specs[plan_.walls.sides[wall].spec]);
        dirty_.insert(chord_of(static_cast<int>(arc)));
      }
  }

  /// Divides the chords that have wishes, and those that have to go on from them.
  void grade() {
    size_scale_.assign(wishes_.size(), 1);
    const std::vector<ArcNeighbours> neighbours = arc_neighbours(layout());
    std::set<int> graded;
    for (int sweep = 0; sweep < max_sweeps && !dirty_.empty(); ++sweep) {
      for (const int chord : dirty_) divide(chord);
      graded.insert(dirty_.begin(), dirty_.end());
      dirty_.clear();
      for (const auto& [a, b] : neighbours) {
        pass_on(a, b, graded);
        pass_on(b, a, graded);
      }
    }
    plan_.chords.assign(graded.begin(), graded.end());
    for (int arc = 0; arc < in_.measured.num_arcs(); ++arc) plan_.is_graded.push_back(graded.count(chord_of(arc)) > 0);
  }

  double interval_at(ArcEnd e) const {
    const std::vector<double>& ends = divisions_[e.arc].ends;
    return (e.end == 0 ? ends[1] : 1 - ends[ends.size() - 2]) * length(e.arc);
  }

  /// Asks for intervals at `to` that go on from those at `from`, where these are far finer.
  void pass_on(ArcEnd from, ArcEnd to, const std::set<int>& graded) {
    const int chord = chord_of(from.arc);
    if (!graded.count(chord)) return;
    const double growth = chord_growth(in_.measured.chords()[chord], wishes_), size = interval_at(from);
    ArcEndWish& wish = wishes_[to.arc][to.end];
    if (interval_at(to) <= std::max(growth, greatest_jump) * size || !wish.cuts.empty()) return;
    if (!wish.is_empty() && wish.before <= size * (1 + equal_tol)) return;
    wish.before = size;
    wish.growth = wish.growth > 0 ? std::min(wish.growth, growth) : growth;
    dirty_.insert(chord_of(to.arc));
  }

  /// New intervals for all arcs of a chord, such that the boundary stays within the tolerance.
  void divide(int chord) {
    for (int round = 0; round < max_tolerance_rounds; ++round) {
      std::vector<double> sizes = arc_sizes_;
      for (std::size_t arc = 0; arc < sizes.size(); ++arc) sizes[arc] *= size_scale_[arc];
      const ChordLayersInput input{in_.measured, in_.measured.chords()[chord], wishes_, sizes, lines_of(chord), 3};
      std::vector<sizing::ArcDivision> divided = layered_divisions(input);
      bool meets = true;
      for (std::size_t i = 0; i < divided.size(); ++i) {
        const int arc = in_.measured.chords()[chord].arcs[i];
        divisions_[arc] = std::move(divided[i]);
        if (!layout().arcs[arc].is_boundary || meets_tolerance(arc)) continue;
        move_onto_breaks(arc);
        if (meets_tolerance(arc)) continue;
        size_scale_[arc] *= shrink;
        meets = false;
      }
      if (meets) return;
    }
  }

  double error(int arc, std::size_t interval) const {
    const std::vector<double>& ends = divisions_[arc].ends;
    if (parts_names(arc, ends[interval], ends[interval + 1])) return std::numeric_limits<double>::infinity();
    return sizing::interval_error(in_.measured.curves(), in_.measured.chain(arc), ends[interval], ends[interval + 1],
                                  in_.order);
  }

  /// Whether a curve of a given name ends inside the interval, as in refine/divide_arcs: no edge may belong to both.
  bool parts_names(int arc, double low, double high) const {
    const std::vector<double> joints = sizing::name_joints(in_.measured.chain(arc), layout().face);
    return std::any_of(joints.begin(), joints.end(),
                       [&](double joint) { return joint > low + same_fraction && joint < high - same_fraction; });
  }

  bool meets_tolerance(int arc) const {
    for (std::size_t k = 0; k + 1 < divisions_[arc].ends.size(); ++k)
      if (error(arc, k) > in_.tolerance) return false;
    return true;
  }

  /// Moves the nearest end of each interval that misses the tolerance onto the break inside it.
  void move_onto_breaks(int arc) {
    std::vector<double>& ends = divisions_[arc].ends;
    for (const double f : in_.measured.chain(arc).break_fractions()) {
      const std::size_t k = std::upper_bound(ends.begin(), ends.end(), f) - ends.begin() - 1;
      if (k + 1 >= ends.size() || error(arc, k) <= in_.tolerance) continue;
      const bool take_low = k > 0 && (f - ends[k] < ends[k + 1] - f || k + 2 == ends.size());
      if (take_low || k + 2 < ends.size()) ends[take_low ? k : k + 1] = f;
    }
  }

  /// The probes of a chord as lines, with what the arcs beside them were asked at ends without a wall left free.
  std::vector<InnerLine> lines_of(int chord) const {
    std::vector<InnerLine> lines;
    for (const ColumnProbe& probe : probes_)
      if (probe.chord == chord) lines.push_back(rest_of_probe(probe, plan_.heights));
    return lines;
  }

  /// Nodes of the arcs that leave walls: in the layers by height, else Gauss-Lobatto-Legendre points of each interval.
  void place_nodes() {
    plan_.arc_nodes.resize(wishes_.size());
    for (std::size_t arc = 0; arc < wishes_.size(); ++arc) {
      if (node_shares_[arc][0].empty() && node_shares_[arc][1].empty()) continue;
      std::vector<double> nodes = interval_nodes(divisions_[arc].ends);
      if (!keeps_cuts(static_cast<int>(arc))) continue;
      const std::vector<double>&low = node_shares_[arc][0], &high = node_shares_[arc][1];
      for (std::size_t k = 0; k < low.size(); ++k) nodes[k + 1] = low[k];
      for (std::size_t k = 0; k < high.size(); ++k) nodes[nodes.size() - 2 - k] = 1 - high[k];
      plan_.arc_nodes[arc] = std::move(nodes);
    }
  }

  /// False where a cut had to move onto a break.
  bool keeps_cuts(int arc) const {
    const std::vector<double>& ends = divisions_[arc].ends;
    const std::vector<double>&low = wishes_[arc][0].cuts, &high = wishes_[arc][1].cuts;
    for (std::size_t k = 0; k < low.size(); ++k)
      if (ends[k + 1] != low[k]) return false;
    for (std::size_t k = 0; k < high.size(); ++k)
      if (ends[ends.size() - 2 - k] != 1 - high[k]) return false;
    return true;
  }

  std::vector<double> interval_nodes(const std::vector<double>& ends) const {
    const std::vector<double>& gll = spectral::gll_points(in_.order);
    std::vector<double> nodes{ends.front()};
    for (std::size_t k = 1; k < ends.size(); ++k)
      for (int i = 1; i <= in_.order; ++i)
        nodes.push_back(i == in_.order ? ends[k] : ends[k - 1] * (1 - gll[i]) / 2 + ends[k] * (1 + gll[i]) / 2);
    return nodes;
  }

  void find_shared() {
    std::vector<std::set<int>> specs(in_.measured.chords().size());
    for (std::size_t arc = 0; arc < wishes_.size(); ++arc)
      for (const int wall : plan_.walls.at_arc_end[arc])
        if (wall >= 0) specs[chord_of(static_cast<int>(arc))].insert(plan_.walls.sides[wall].spec);
    std::set<std::array<int, 2>> pairs;
    for (const std::set<int>& s : specs)
      for (auto a = s.begin(); a != s.end(); ++a)
        for (auto b = std::next(a); b != s.end(); ++b) pairs.insert({*a, *b});
    plan_.shared.assign(pairs.begin(), pairs.end());
  }

  const WallInput& in_;
  sizing::ArcDivisions& divisions_;
  std::vector<double> arc_sizes_;  ///< wanted interval on each arc
  WallPlan plan_;
  std::vector<ColumnProbe> probes_;
  ArcWishes wishes_;
  std::vector<std::array<std::vector<double>, 2>> node_shares_;  ///< by arc and end: nodes in the layers
  std::vector<double> size_scale_;  ///< by arc: what the tolerance makes of the wanted size
  std::set<int> dirty_;             ///< chords to be divided
};

}  // namespace

bool WallPlan::has_wall(int block) const {
  const std::array<int, 4>& sides = walls.of_block[block];
  return std::any_of(sides.begin(), sides.end(), [](int wall) { return wall >= 0; });
}

WallPlan plan_walls(const WallInput& input, sizing::ArcDivisions& divisions) {
  return WallPlanner(input, divisions).plan();
}

LayeredBlock layered_block(const WallPlan& plan, const sizing::MeasuredLayout& measured, int block,
                           std::array<std::vector<double>, 4> fractions) {
  LayeredBlock result;
  for (int side = 0; side < 4; ++side) {
    const HalfEdge directed = measured.blocks().block2arcs[block][side];
    const int number = plan.walls.of_block[block][side];
    const curve::Chain& chain = measured.chain(directed.arc);
    result.lengths[side] = chain.length();
    result.tables[side] = SideTable(chain, directed.is_backwards != (side >= 2));
    if (number < 0) continue;
    const WallSide& wall = plan.walls.sides[number];
    result.sides[side].wall = &wall.line;
    result.sides[side].heights = plan.heights[wall.spec];
    for (const double f : fractions[side]) {  // sides 2 and 3 are walked against s and t
      const curve::ChainPoint p = chain.at(directed.is_backwards != (side >= 2) ? 1 - f : f);
      const int piece = directed.is_backwards ? wall.end.piece - p.piece : wall.begin.piece + p.piece;
      result.sides[side].feet.push_back({piece, p.t});
    }
  }
  result.fractions = std::move(fractions);
  return result;
}

void tell_walls(const WallPlan& plan, const std::vector<WallSpec>& specs, Report& report) {
  const auto names = [&](int spec) { return fmt::format("{}", fmt::join(specs[spec].names, ",")); };
  for (std::size_t i = 0; i < specs.size(); ++i) {
    const std::string key = fmt::format("walls.{}.", i);
    report.set(key + "names", names(static_cast<int>(i)));
    report.set(key + "layers", plan.heights[i].size());
    report.set(key + "first", plan.heights[i].front());
    report.set(key + "thickness", plan.heights[i].back());
  }
  for (const auto& [a, b] : plan.shared)
    report.warn("W-WAL-001", fmt::format("the walls {} and {} ask for layers on one chord: each gets its own heights, "
                                         "and both the chord's count",
                                         names(a), names(b)));
  for (const auto& [loser, winner] : plan.walls.overruled)
    report.warn("W-WAL-002", fmt::format("the walls {} and {} go on from each other: along both are the layers of {}",
                                         names(loser), names(winner), names(winner)));
}

}  // namespace quadrille::layers
