#pragma once
// A line that ends on the boundary ends at another point of it instead: the line becomes a blend
// (simplify/chord_blend.hpp) into the normal there.

#include <optional>

#include "curve/chain.hpp"
#include "field/evaluate.hpp"
#include "graph/arc_pieces.hpp"
#include "graph/subdivision.hpp"

namespace quadrille::simplify {

/// The end of one line that would move along the boundary, within the arc beside it.
struct LineEndMove {
  int curve = 0;  ///< where to, with the parameter
  double t = 0;
  Vec2 position;
  int node = -1;
  HalfEdge line;                    ///< ends at the node
  int shortened = -1, longer = -1;  ///< boundary arcs at the node: the one along which it moves, the other
  graph::Pieces left, gained;       ///< of the shortened arc: what it keeps, what the other gets
  bool is_forwards = true;          ///< along the boundary
  double length = 0;                ///< of the boundary between
};

/// The move to `at` on a boundary arc of the end at its start, or at its end (not `is_forwards`). std::nullopt unless
/// one line ends at the node, and it is regular there.
std::optional<LineEndMove> line_end_move(const graph::Subdivision& subdivision, int arc, const curve::ChainPoint& at,
                                         bool is_forwards);

/// Moves the end. With fields, returns the largest deviation of the blend from the cross of the field, radians.
double move_line_end(graph::Subdivision& subdivision, const LineEndMove& move,
                     const field::FieldsOfRegions* fields = nullptr);

}  // namespace quadrille::simplify
