#include "sizing/halved_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/tolerance.hpp"
#include "curve/symmetry_lines.hpp"
#include "mesh/transfinite.hpp"

namespace quadrille::sizing {
namespace {

constexpr int samples_on_line = 32;
constexpr double least_slope = 0.02;  ///< of the parameter

/// The arcs on one line of symmetry.
class ArcsOnLine {
 public:
  ArcsOnLine(const BlockLayout& layout, const curve::SymmetryLine& line) : layout_(layout) {
    for (const GraphArc& arc : layout.arcs)
      is_on_line_.push_back(std::ranges::all_of(
          arc.pieces, [&](const ArcPiece& piece) { return std::ranges::binary_search(line.curves, piece.curve); }));
    mark_lines_of_whole();
  }

  bool contains(int arc) const { return is_on_line_[arc]; }
  /// Whether the whole has a line of blocks there.
  bool is_line_of_whole(int arc) const { return is_line_of_whole_[arc]; }

 private:
  /// A line runs on through regular nodes; it starts at irregular ones and at corners of the whole.
  void mark_lines_of_whole() {
    const std::size_t num_arcs = layout_.arcs.size(), num_nodes = layout_.nodes.size();
    std::vector<std::vector<int>> arcs_at(num_nodes);
    DisjointSets connected(num_arcs);
    for (std::size_t a = 0; a < num_arcs; ++a)
      if (is_on_line_[a])
        for (const int node : {layout_.arcs[a].from, layout_.arcs[a].to}) arcs_at[node].push_back(static_cast<int>(a));
    std::vector<bool> starts_at(num_arcs, false);
    for (std::size_t n = 0; n < num_nodes; ++n) {
      if (arcs_at[n].size() == 2 && layout_.nodes[n].valence == 2)
        connected.unite(arcs_at[n][0], arcs_at[n][1]);
      else if (arcs_at[n].size() == 2 || is_corner_of_whole(layout_.nodes[n]))
        for (const int arc : arcs_at[n]) starts_at[arc] = true;
    }
    std::vector<bool> is_line(num_arcs, false);
    for (std::size_t a = 0; a < num_arcs; ++a)
      if (starts_at[a]) is_line[connected.find(static_cast<int>(a))] = true;
    for (std::size_t a = 0; a < num_arcs; ++a)
      is_line_of_whole_.push_back(is_line[connected.find(static_cast<int>(a))]);
  }

  bool is_corner_of_whole(const GraphNode& node) const {
    return curve::is_corner_of_whole(layout_.face.joints[node.curve].interior_angle);
  }

  const BlockLayout& layout_;
  std::vector<bool> is_on_line_, is_line_of_whole_;
};

/// The fractions of an arc on the line, in the direction of its chord, at which the lines of the whole meet it.
/// `other`: the opposite arc of its block; both are given by their positions in the chord.
std::vector<double> fractions_of_whole(const MeasuredLayout& layout, const mesh::Chord& chord, int on_line, int other,
                                       Vec2 direction) {
  const auto along = [&](int i, double fraction) {
    return dot(direction, layout.chain(chord.arcs[i]).position(fraction));
  };
  const auto end_of = [&](int i, bool is_last) { return along(i, is_last != chord.backwards[i] ? 1.0 : 0.0); };
  const double length = end_of(on_line, true) - end_of(on_line, false);
  std::vector<double> fractions{0.0};
  for (int k = 1; k < samples_on_line; ++k) {
    const double own = layout.arc_fraction(chord, other, static_cast<double>(k) / samples_on_line);
    const double f = chord.backwards[other] ? 1 - own : own;
    const double on_chord = (1 - f) * end_of(other, false) + f * end_of(other, true);
    fractions.push_back(f + (along(other, own) - on_chord) / length);
  }
  fractions.push_back(1.0);
  return fractions;
}

bool are_in_order(const std::vector<double>& fractions) {
  for (std::size_t k = 1; k < fractions.size(); ++k)
    if (!(fractions[k] - fractions[k - 1] >= least_slope / samples_on_line)) return false;
  return true;
}

bool are_equal(const std::vector<double>& fractions) {
  for (std::size_t k = 0; k < fractions.size(); ++k)
    if (std::abs(fractions[k] - static_cast<double>(k) / samples_on_line) > tolerance::tied) return false;
  return true;
}

/// Of the arc at a side of a block, in the direction of its chord.
std::vector<double> fractions_of_whole(const MeasuredLayout& layout, int block, const HalvedSide& halved) {
  const auto& sides = layout.blocks().block2arcs[block];
  const int arc = sides[halved.side].arc, other = sides[(halved.side + 2) % 4].arc;
  return fractions_of_whole(layout, layout.chords()[layout.chord_of(arc)], layout.position_in_chord(arc),
                            layout.position_in_chord(other), halved.line.direction);
}

/// By block: the sides on which the lines of the whole are in order and not at equal fractions.
HalvedSides halved_sides(const MeasuredLayout& layout, const std::vector<std::string>& symmetry) {
  const BlockLayout& blocks = layout.blocks();
  const std::vector<curve::SymmetryLine> lines =
      curve::symmetry_lines(blocks.face, curve::curves_that_fit(blocks.face, symmetry)).lines;
  if (!curve::is_part_of_whole(lines)) return {};
  HalvedSides result(blocks.block2arcs.size());
  for (const curve::SymmetryLine& line : lines) {
    const ArcsOnLine on_line(blocks, line);
    for (int b = 0; b < blocks.num_blocks(); ++b)
      for (int side = 0; side < 4; ++side) {
        const int arc = blocks.block2arcs[b][side].arc, other = blocks.block2arcs[b][(side + 2) % 4].arc;
        if (!on_line.contains(arc) || on_line.is_line_of_whole(arc) || on_line.contains(other)) continue;
        const HalvedSide halved{side, line};
        const std::vector<double> fractions = fractions_of_whole(layout, b, halved);
        if (are_in_order(fractions) && !are_equal(fractions)) result[b] = halved;
      }
  }
  return result;
}

/// The coordinate of (s, t) that leads away from the side, or up to it.
double& across(Vec2& st, int side) { return side % 2 == 0 ? st.y : st.x; }

bool is_first(int side) { return side == 0 || side == 3; }

}  // namespace

MeasuredLayout with_lines_of_whole(const MeasuredLayout& layout, const std::vector<std::string>& symmetry) {
  HalvedSides sides = halved_sides(layout, symmetry);
  std::vector<ArcParameter> parameters;
  for (int arc = 0; arc < layout.num_arcs(); ++arc) parameters.push_back(layout.parameter(arc));
  for (int b = 0; b < static_cast<int>(sides.size()); ++b) {
    if (!sides[b]) continue;
    const int arc = layout.blocks().block2arcs[b][sides[b]->side].arc;
    std::vector<double> fractions = fractions_of_whole(layout, b, *sides[b]);
    if (layout.chords()[layout.chord_of(arc)].backwards[layout.position_in_chord(arc)]) reverse_fractions(fractions);
    parameters[arc] = ArcParameter(std::move(fractions));
  }
  return layout.with_parameters(std::move(parameters), std::move(sides));
}

Vec2 blend_of_whole(std::array<Vec2, 4> on_sides, std::array<Vec2, 4> corners, Vec2 st, const HalvedSide& halved) {
  const int side = halved.side, after = (side + 1) % 4, opposite = (side + 2) % 4, before = (side + 3) % 4;
  on_sides[side] = halved.line(on_sides[opposite]);
  corners[side] = halved.line(corners[before]);
  corners[after] = halved.line(corners[opposite]);
  double& part = across(st, side);
  part = is_first(side) ? (1 + part) / 2 : part / 2;
  return mesh::blend_sides(on_sides, corners, st.x, st.y);
}

Vec2 position_in_whole(SidePoints points, const HalvedSide& halved) {
  const int side = halved.side, after = (side + 1) % 4, opposite = (side + 2) % 4, before = (side + 3) % 4;
  auto& [positions, corners, fractions] = points;
  fractions[side] = fractions[opposite];
  Vec2 st = mesh::crossing_parameters(fractions[0], fractions[1], fractions[2], fractions[3]);
  const Vec2 position = blend_of_whole(positions, corners, st, halved);
  double& part = across(st, side);
  const double from_line = is_first(side) ? part : 1 - part;
  part = is_first(side) ? 0 : 1;
  positions[before] = corners[side], positions[after] = corners[after];
  // Divisions of the side may be others: they are met there, and matter the less the farther away the point is.
  return position + (1 - from_line) * (positions[side] - blend_of_whole(positions, corners, st, halved));
}

}  // namespace quadrille::sizing
