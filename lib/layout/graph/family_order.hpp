#pragma once
// Lines of one family never cross: along every edge of an element, and so everywhere, they keep their order. Two lines
// either cross at right angles, up to the error of their integration, or belong to one family.

#include <vector>

#include "base/error.hpp"
#include "graph/crossings.hpp"

namespace quadrille::graph {

/// Whether a crossing can only be one of lines of one family.
bool is_of_one_family(const Crossing& crossing);

/// Two lines of one family cross: lines integrated more accurately may not.
struct FamilyOrderError : ComputeError {
  using ComputeError::ComputeError;
};

/// Throws FamilyOrderError with the position where two lines of one family cross at more than a milliradian: the
/// tolerance of their integration was too large for the field there. `is_exempt`, by line of the crossings: lines bent
/// by a merge may cross their neighbours. Crossings at common ends must have been removed before.
void require_family_order(const std::vector<Crossing>& crossings, const std::vector<bool>& is_exempt, Vec2 origin);

}  // namespace quadrille::graph
