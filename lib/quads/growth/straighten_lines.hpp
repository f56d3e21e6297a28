#pragma once
// Shifts of lines along the rows that they cross, after which they are nearly normal to the rows.
//
// The lines from a wall to the far side of its block connect equal fractions of both sides. Where these bend
// differently, as the nose of an aerofoil and a far field 20 chords away, lines are oblique to the layers. With the
// rows and the ends of the lines kept, vertex i of row j moves to x_ij on its row, in intervals of the row. The shifts
// x_ij - i minimise
//
//   sum over edges of lines  c^2 + c^4 / oblique^2      c the cotangent of the angle between the edge and its rows
//     + smoothness * sum over adjacent intervals of rows  (ln (w' / w) - ln (w0' / w0))^2
//     + excess_weight * sum over adjacent edges of rows and lines  max(0, |ln (d' / d)| - r)^2,
//
// w intervals of rows after and w0 before, d edges, r a part of the logarithm of the growth limit, or what the ratio
// was before. As edges grow with the distance from the wall, equal angles in all of them turn a line by as much for
// each factor of the distance: over 20 chords a small one suffices, and little of it lies in the layers.

#include <vector>

#include "base/vec2.hpp"
#include "layers/shift_along_rows.hpp"

namespace quadrille::growth {

struct StraightenConstants {
  double oblique = 0.5;         ///< cotangent at which both powers are equal
  double smoothness = 50;       ///< weight of changes of the growth along rows
  double excess_weight = 300;   ///< of edges that grow faster than the limit
  double margin = 0.1;          ///< part of the limit's logarithm that is left for what follows
  double least_interval = 0.1;  ///< part of its interval that is left of one
  double flat = 1e-3;           ///< sine of the least angle that is told from 0
  int max_steps = 12;           ///< Gauss-Newton steps
  double least_change = 1e-3;   ///< of a shift, in intervals, in a step that is not the last
  double least_part = 1e-3;     ///< of a step, which is halved until it reduces the sum
};
inline constexpr StraightenConstants straighten_constants;

/// The vertices of a block. The lines cross the rows: line i consists of the vertices i of all rows.
struct VertexRows {
  std::vector<std::vector<Vec2>> rows;  ///< at least two, of at least two vertices
  int fixed_first = 1, fixed_last = 1;  ///< numbers of vertices, at least 1, that stay at both ends of each row
};

/// `limit`: of the ratio of adjacent edges, > 1. Cost: a sparse factorisation of the vertices' number in each step.
layers::RowShifts straightening_shifts(const VertexRows& block, double limit);

}  // namespace quadrille::growth
