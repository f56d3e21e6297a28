#pragma once
// The lines of one half of a symmetric whole in blocks that are halves of blocks of the whole.
//
// Where no line of the whole's blocks runs along the line of symmetry, that divides blocks in their middle. There the
// map of such a block moves the points of equal fractions along the line as far as the points on its two other sides,
// which are mirror images of each other, lie ahead of those on their chords. The half has a side of its own on the line
// and only one of these sides: its lines would be straight behind a nose where those of the whole follow the body.

#include <string>
#include <vector>

#include "sizing/measured_layout.hpp"

namespace quadrille::refine {

/// The layout with other parameters of such arcs on lines of symmetry: its lines meet them where those of the whole do.
/// Arcs on which they would be out of order, or nearly so, keep their parameters. `symmetry`: patterns of the names of
/// curves (curve/symmetry_lines.hpp).
sizing::MeasuredLayout with_lines_of_whole(const sizing::MeasuredLayout& layout,
                                           const std::vector<std::string>& symmetry);

}  // namespace quadrille::refine
