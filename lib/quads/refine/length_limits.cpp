#include "refine/length_limits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "refine/shortest_kept_edge.hpp"

namespace quadrille::refine {
namespace {

/// Beside a short boundary between two corners, elements have a side as short as that in any case.
constexpr double edge_elongation = 3;
/// Elements are shortened to less than the limit asks for: between breaks they may be longer than planned by a quarter
/// (refine/settle_counts).
constexpr double aim = 0.7;
constexpr double least_factor = 1.05;
/// Below the prescribed size.
constexpr double greatest_factor = 100;

/// An element of a block: i along side 0, j along side 1.
struct GridElement {
  int block = 0, i = 0, j = 0;
};

/// Counter-clockwise.
std::array<Vec2, 4> corners_of(const QuadMesh& mesh, int elem) {
  const int n = mesh.order, num_nodes = (n + 1) * (n + 1);
  const auto node = [&](int k) { return mesh.nodes[mesh.elem_nodes[elem * num_nodes + k]]; };
  return {node(0), node(n), node(num_nodes - 1), node(num_nodes - 1 - n)};
}

std::array<double, 4> side_lengths(const std::array<Vec2, 4>& corners) {
  std::array<double, 4> lengths;
  for (int side = 0; side < 4; ++side) lengths[side] = distance(corners[side], corners[(side + 1) % 4]);
  return lengths;
}

class LimitFinder {
 public:
  LimitFinder(const sizing::MeasuredLayout& measured, const std::vector<sizing::ChordPlan>& plans,
              const sizing::ArcDivisions& divisions, LengthLimits& limits)
      : measured_(measured), plans_(plans), divisions_(divisions), limits_(limits) {
    limits_.resize(measured.chords().size());
  }

  /// Makes the element shorter by a factor along its sides `side` and side + 2; false if its chord has a prescribed
  /// count.
  bool shorten(const GridElement& elem, int side, double factor) {
    const int chord = measured_.chord_of(measured_.blocks().block2arcs[elem.block][side].arc);
    if (plans_[chord].is_prescribed) return false;
    const auto [a, b] = interval(elem, side);
    const auto [c, d] = interval(elem, side + 2);
    const double low = std::min(a, c), high = std::max(b, d);
    limits_[chord].push_back({low, high, std::max(b - a, d - c) / factor, 1});
    return true;
  }

 private:
  /// The part of the chord's parameter that a side of the element covers.
  std::pair<double, double> interval(const GridElement& elem, int side) const {
    const HalfEdge directed = measured_.blocks().block2arcs[elem.block][side];
    const int count = divisions_[directed.arc].num_intervals(), along = side % 2 == 0 ? elem.i : elem.j;
    const int in_side = side < 2 ? along : count - 1 - along;
    const int k = directed.is_backwards ? count - 1 - in_side : in_side;
    const mesh::Chord& chord = measured_.chords()[measured_.chord_of(directed.arc)];
    const auto position = std::find(chord.arcs.begin(), chord.arcs.end(), directed.arc) - chord.arcs.begin();
    const double a = measured_.chord_parameter(chord, static_cast<int>(position), divisions_[directed.arc].low(k));
    const double b = measured_.chord_parameter(chord, static_cast<int>(position), divisions_[directed.arc].high(k));
    return std::minmax(a, b);
  }

  const sizing::MeasuredLayout& measured_;
  const std::vector<sizing::ChordPlan>& plans_;
  const sizing::ArcDivisions& divisions_;
  LengthLimits& limits_;
};

/// The elements of all blocks in the order of the mesh (refine/split_isoparametric).
std::vector<GridElement> grid_elements(const BlockLayout& layout, const sizing::ArcDivisions& divisions) {
  std::vector<GridElement> elems;
  for (int block = 0; block < layout.num_blocks(); ++block) {
    const int columns = divisions[layout.block2arcs[block][0].arc].num_intervals();
    const int rows = divisions[layout.block2arcs[block][1].arc].num_intervals();
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i) elems.push_back({block, i, j});
  }
  return elems;
}

}  // namespace

bool add_length_limits(const sizing::MeasuredLayout& measured, const std::vector<sizing::ChordPlan>& plans,
                       const sizing::ArcDivisions& divisions, const QuadMesh& mesh, const sizing::SizeField& sizes,
                       double target, const std::vector<bool>& is_left_out, LengthLimits& limits) {
  if (std::ranges::all_of(mesh.elem_edge_ratio, [&](double ratio) { return ratio <= target; })) return false;
  const std::vector<GridElement> elems = grid_elements(measured.blocks(), divisions);
  LimitFinder finder(measured, plans, divisions, limits);
  bool is_any = false;
  const double shortest = shortest_kept_edge(measured);
  for (int e = 0; e < mesh.num_elems(); ++e) {
    if (mesh.elem_edge_ratio[e] <= target || (!is_left_out.empty() && is_left_out[e])) continue;
    const std::array<Vec2, 4> corners = corners_of(mesh, e);
    const double size = sizes.at(0.5 * (corners[0] + corners[2]), measured.region_of_block(mesh.elem_block[e]));
    const double excess = mesh.elem_edge_ratio[e] / std::max(target, edge_elongation * size / shortest);
    if (excess <= 1) continue;
    const std::array<double, 4> lengths = side_lengths(corners);
    const auto longest = std::max_element(lengths.begin(), lengths.end());
    const double factor = std::min(excess / aim, *longest * greatest_factor / size);
    if (factor < least_factor) continue;
    is_any |= finder.shorten(elems[e], static_cast<int>(longest - lengths.begin()) % 2, factor);
  }
  return is_any;
}

void apply_length_limits(const LengthLimits& limits, std::vector<sizing::ChordPlan>& plans) {
  for (std::size_t c = 0; c < limits.size(); ++c) {
    if (limits[c].empty() || plans[c].is_prescribed) continue;
    plans[c].slope = std::max(plans[c].slope, std::log(sizing::SizeField::default_growth));
    plans[c].grading = sizing::refine_grading(plans[c].grading, plans[c].count, limits[c], plans[c].slope);
    plans[c].count = static_cast<int>(sizing::whole_count(plans[c].grading.count(), sizing::SizeRule::at_most));
  }
}

}  // namespace quadrille::refine
