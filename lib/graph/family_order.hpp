#pragma once
// Lines of one family never cross: along every edge of an element, and so everywhere, they keep their sequence. Two
// lines cross at right angles but for the error of their integration, or they belong to one family.

#include <vector>

#include "graph/crossings.hpp"

namespace quadrille::graph {

/// Whether a crossing can only be one of lines of one family.
bool is_of_one_family(const Crossing& crossing);

/// Throws ComputeError with the place where two lines of one family cross by more than a milliradian: they were not
/// followed as accurately as the field asks for there. `is_exempt`, of the lines that the crossings name: what a merge
/// has bent may cross its neighbour. Crossings at common ends must have been left out.
void require_family_order(const std::vector<Crossing>& crossings, const std::vector<bool>& is_exempt, Vec2 origin);

}  // namespace quadrille::graph
