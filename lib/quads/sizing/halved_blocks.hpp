#pragma once
// Blocks of one half of a symmetric whole that are halves of blocks of the whole.
//
// Where no line of the whole's blocks runs along the line of symmetry, that divides blocks in their middle. The map of
// such a half is that of the whole block: its side on the line is not among the sides of the whole block, and the
// mirror image of the opposite side is. There the lines of the block meet the line of symmetry as far ahead of equal
// fractions as the points of the opposite side lie ahead of those on its chord. With a straight side of its own the
// block would have skew elements at a nose.

#include <array>
#include <string>
#include <vector>

#include "sizing/measured_layout.hpp"

namespace quadrille::sizing {

/// The layout with its halved sides: those on which the lines of the whole are in order and not at equal fractions. Its
/// lines meet them where those of the whole do. `symmetry`: patterns of the names of curves (curve/symmetry_lines.hpp).
MeasuredLayout with_lines_of_whole(const MeasuredLayout& layout, const std::vector<std::string>& symmetry);

/// The point of the whole block's map at (s, t) of the half. `on_sides`, `corners`: as for mesh::blend_sides of the
/// half; the point on its halved side does not count.
Vec2 blend_of_whole(std::array<Vec2, 4> on_sides, std::array<Vec2, 4> corners, Vec2 st, const HalvedSide& halved);

/// A point of a block: of each side the point at the same place along the block, and the fraction of the length there,
/// in the direction of rising s (sides 0, 2) or t (sides 1, 3).
struct SidePoints {
  std::array<Vec2, 4> positions, corners;
  std::array<double, 4> fractions;
};

/// Where the map of the whole block has this point.
Vec2 position_in_whole(SidePoints points, const HalvedSide& halved);

}  // namespace quadrille::sizing
