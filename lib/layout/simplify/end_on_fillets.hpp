#pragma once
// Lines that end beside a small fillet end at its middle instead (lib/method.md §5, small features).
//
// Where the node of a fillet was moved away from it, the field next to the fillet turns as at a corner without a node,
// and magnifies every error of the line towards it by the square of distance over radius: the line misses the fillet,
// which is then inside a side of a block. The end of such a line is moved along the boundary to the fillet, if the
// worst of the blocks beside it becomes better.

#include <vector>

#include "field/evaluate.hpp"
#include "graph/candidate_layout.hpp"

namespace quadrille::simplify {

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
