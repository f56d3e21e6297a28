#pragma once
// Doubles the vertices on slits, so that the elements on both sides of a slit are not neighbours.

#include <vector>

#include "triangulate/draft.hpp"

namespace quadrille::triangulate {

/// Gives each vertex where boundary edges meet one copy for each sector between them. A sector without a copy keeps the
/// vertex itself; at the tip of a slit there is one sector. Copies are added at the end of draft.vertices, in the order
/// of their vertices. Returns the vertex from which each vertex was copied, itself for the others.
std::vector<int> cut_slits(Draft& draft);

}  // namespace quadrille::triangulate
