#include "refine/length_limits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "model/quad_mesh.hpp"

namespace quadrille::refine {
namespace {

class BoundaryWalk {
 public:
  explicit BoundaryWalk(const sizing::MeasuredLayout& measured)
      : measured_(measured), arcs_at_(measured.blocks().nodes.size()) {
    for (int a = 0; a < measured.num_arcs(); ++a)
      if (arc(a).is_boundary) arcs_at_[arc(a).from].push_back(a), arcs_at_[arc(a).to].push_back(a);
  }

  bool is_corner(int node) const { return measured_.blocks().nodes[node].kind == NodeKind::corner; }
  const std::vector<int>& arcs_at(int node) const { return arcs_at_[node]; }

  /// From a corner along boundary arc `a` to the next corner or joint of names. It ends in layouts from damaged files
  /// too, whose boundary need not lead back to a corner.
  double length_from(int corner, int a) const {
    double length = 0;
    int node = corner;
    for (int passed = 0; passed < measured_.num_arcs(); ++passed, a = other_arc(node, a)) {
      const std::vector<double> joints = measured_.name_joints(a);
      const bool is_forward = arc(a).from == node;
      if (!joints.empty()) return length + measured_.length(a) * (is_forward ? joints.front() : 1 - joints.back());
      length += measured_.length(a);
      node = is_forward ? arc(a).to : arc(a).from;
      if (is_corner(node)) return length;
    }
    return length;
  }

 private:
  const GraphArc& arc(int a) const { return measured_.blocks().arcs[a]; }
  int other_arc(int node, int a) const {
    const std::vector<int>& both = arcs_at_[node];
    return both.front() == a ? both.back() : both.front();
  }

  const sizing::MeasuredLayout& measured_;
  std::vector<std::vector<int>> arcs_at_;  // the two boundary arcs at each boundary node
};

struct LimitConstants {
  double edge_elongation = 3;  ///< beside a short boundary between two corners, elements have a side as short anyway
  /// Elements are shortened to less than the limit asks for: between breaks they may be longer than planned by a
  /// quarter (refine/chord_division).
  double aim = 0.7;
  double least_factor = 1.05;    ///< by which an element is shortened
  double greatest_factor = 100;  ///< below the prescribed size
};
constexpr LimitConstants limit_constants;

/// An element of a block: i along side 0, j along side 1.
struct GridElement {
  int block = 0, i = 0, j = 0;
};

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
    const auto parameter = [&](double fraction) {
      return measured_.chord_parameter(chord, measured_.position_in_chord(directed.arc), fraction);
    };
    return std::minmax({parameter(divisions_[directed.arc].low(k)), parameter(divisions_[directed.arc].high(k))});
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

double shortest_kept_edge(const sizing::MeasuredLayout& measured) {
  const BoundaryWalk walk(measured);
  double shortest = std::numeric_limits<double>::infinity();
  for (int node = 0; node < static_cast<int>(measured.blocks().nodes.size()); ++node)
    if (walk.is_corner(node))
      for (const int a : walk.arcs_at(node)) shortest = std::min(shortest, walk.length_from(node, a));
  for (int a = 0; a < measured.num_arcs(); ++a) {
    if (!measured.is_on_cad_curve(a)) continue;
    const std::vector<double> joints = measured.name_joints(a);
    for (std::size_t k = 1; k < joints.size(); ++k)
      shortest = std::min(shortest, (joints[k] - joints[k - 1]) * measured.length(a));
  }
  return shortest;
}

bool add_length_limits(const sizing::MeasuredLayout& measured, const std::vector<sizing::ChordPlan>& plans,
                       const sizing::ArcDivisions& divisions, const QuadMesh& mesh, const sizing::SizeField& sizes,
                       double target, double shortest, const std::vector<bool>& is_left_out, LengthLimits& limits) {
  if (std::ranges::all_of(mesh.elem_edge_ratio, [&](double ratio) { return ratio <= target; })) return false;
  const std::vector<GridElement> elems = grid_elements(measured.blocks(), divisions);
  LimitFinder finder(measured, plans, divisions, limits);
  bool is_any = false;
  for (int e = 0; e < mesh.num_elems(); ++e) {
    if (mesh.elem_edge_ratio[e] <= target || (!is_left_out.empty() && is_left_out[e])) continue;
    const auto corner = [&](int side) { return mesh.nodes[side_start(mesh, e, side % 4)]; };
    const double size = sizes.at(0.5 * (corner(0) + corner(2)), measured.region_of_block(mesh.elem_block[e]));
    const double excess = mesh.elem_edge_ratio[e] / std::max(target, limit_constants.edge_elongation * size / shortest);
    if (excess <= 1) continue;
    std::array<double, 4> lengths;
    for (int side = 0; side < 4; ++side) lengths[side] = distance(corner(side), corner(side + 1));
    const auto longest = std::ranges::max_element(lengths);
    const double factor = std::min(excess / limit_constants.aim, *longest * limit_constants.greatest_factor / size);
    if (factor < limit_constants.least_factor) continue;
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
