#pragma once
// Moves the nodes of a block along its rows.

#include <vector>

#include "base/vec2.hpp"

namespace quadrille::layers {

/// By row and column of the vertices of a block: how far a vertex moves along its row, in intervals of the row.
using RowShifts = std::vector<std::vector<double>>;

/// Nodes of elements of this order in rows of `width` nodes, positions or parameters in the block, after the shifts.
/// Nodes between vertices move with these; those of the first and the last row, and of both ends of each row, stay.
/// Nodes do not move exactly along the curve of their row: their change is that of an interpolation of its vertices.
std::vector<Vec2> shifted_along_rows(const std::vector<Vec2>& nodes, int width, int order, const RowShifts& shifts);

}  // namespace quadrille::layers
