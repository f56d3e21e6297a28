#pragma once
// Lines that end on the boundary end at another point of it instead: the line becomes a blend
// (simplify/chord_blend.hpp) into the normal there. So do lines beside a small fillet, which end at its middle instead
// (lib/method.md §5, small features).
//
// Where the node of a fillet was moved away from it, the field next to the fillet turns as at a corner without a node,
// and magnifies every error of the line towards it by the square of distance over radius: the line misses the fillet,
// which is then inside a side of a block. The end of such a line is moved along the boundary to the fillet, if the
// worst of the blocks beside it becomes better.

#include <optional>
#include <vector>

#include "field/evaluate.hpp"
#include "graph/arc_pieces.hpp"
#include "graph/candidate_layout.hpp"

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

/// The last arc of the regular line that ends at a node of the boundary; -1 if it is another node.
int line_ending_at(const graph::Subdivision& subdivision, int node);

/// The move to a point of a CAD curve, inside a boundary arc, of the end at the arc's start, or at its end (not
/// `is_forwards`). std::nullopt if the arc does not contain the point, or unless one line ends at the node, and it is
/// regular there.
std::optional<LineEndMove> line_end_move(const graph::Subdivision& subdivision, int arc, int curve, double t,
                                         bool is_forwards);

/// Moves the end. Returns the largest deviation of the blend from the cross of the field, radians.
double move_line_end(graph::Subdivision& subdivision, const LineEndMove& move, const field::FieldsOfRegions& fields);

/// The middle of a fillet: a point of the boundary, inside a smooth part of it.
struct FilletMiddle {
  int curve = 0;
  double t = 0;
};

struct FilletEnds {
  int num_moved = 0;
  double deviation = 0;  ///< the largest of the moved lines from the cross of the field, radians
};

/// For each fillet the regular ends of lines that are next to it along the boundary are tried; the one that makes the
/// better blocks is moved, the line becomes a blend (simplify/chord_blend.hpp) into the normal at the fillet. Ends that
/// move by equal lengths (within 1e-6 diameters) are moved together or not at all. Every face must have four corners,
/// and keeps them; the graph's numbers stay.
FilletEnds end_lines_on_fillets(const field::FieldsOfRegions& fields, const std::vector<FilletMiddle>& fillets,
                                graph::CandidateLayout& layout);

}  // namespace quadrille::simplify
