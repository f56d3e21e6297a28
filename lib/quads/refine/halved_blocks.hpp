#pragma once
// Blocks of one half of a symmetric whole that are halves of blocks of the whole.
//
// Where no line of the whole's blocks runs along the line of symmetry, that divides blocks in their middle. The map of
// such a half is that of the whole block: its side on the line is not among the sides of the whole block, and the
// mirror image of the opposite side is. There the lines of the block meet the line of symmetry as far ahead of equal
// fractions as the points of the opposite side lie ahead of those on its chord. With a straight side of its own the
// block would have skew elements at a nose.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "curve/symmetry_lines.hpp"
#include "sizing/measured_layout.hpp"

namespace quadrille::refine {

/// The side of a block on the line that divides the block of the whole.
struct HalvedSide {
  int side = 0;
  curve::SymmetryLine line;
};

/// By block; empty if there are none.
using HalvedSides = std::vector<std::optional<HalvedSide>>;

/// Those on which the lines of the whole are in order and not at equal fractions. `symmetry`: patterns of the names of
/// curves (curve/symmetry_lines.hpp).
HalvedSides halved_sides(const sizing::MeasuredLayout& layout, const std::vector<std::string>& symmetry);

/// The layout with other parameters of the arcs at these sides: its lines meet them where those of the whole do.
sizing::MeasuredLayout with_lines_of_whole(const sizing::MeasuredLayout& layout, const HalvedSides& sides);

/// A point of a block: of each side the point at the same place along the block, and the fraction of the length there,
/// in the direction of rising s (sides 0, 2) or t (sides 1, 3).
struct SidePoints {
  std::array<Vec2, 4> positions, corners;
  std::array<double, 4> fractions;
};

/// Where the map of the whole block has this point.
Vec2 position_in_whole(SidePoints points, const HalvedSide& halved);

}  // namespace quadrille::refine
