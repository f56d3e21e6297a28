#pragma once
// Zeros so near to a corner that no block fits between: the corner takes them in, V becomes V + sum (V_k - 4).
//
// A node no farther than `length` from a corner, with the way to it in the domain, is absorbed when the new valence is
// admissible: blocks of angle / V between 15 and 165 degrees, and |V - 2 omega / pi| <= 0.75, so that the corner's
// blocks stay near right angles. V = 0 (a degenerate corner) is taken only within 0.02 radians of the tie at 45
// degrees. Close to a tie both neighbours are admissible, and what comes out is the count of quarter turns along an arc
// of radius `length`. Only corners of the layout absorb: a smooth boundary point is none.
// A node as near to two corners goes to neither; nodes as near to one corner go to it together or not at all; nearer
// ones go first. Equal is within 1e-6 of `length`.

#include <vector>

#include "model/critical_points.hpp"
#include "zeros/zero_search.hpp"

namespace quadrille::guide {

/// Whether a corner may take that valence by absorbing nodes.
bool may_become(double angle_degrees, int valence);

/// Changes `corners` and adds a change of the kind "absorb" for each that takes zeros in. Returns which zeros were.
std::vector<bool> absorb_into_corners(const field::FieldEvaluator& evaluator,
                                      const std::vector<zeros::FoundZero>& zeros, double length,
                                      std::vector<Corner>& corners, std::vector<NodeChange>& changes);

}  // namespace quadrille::guide
