#pragma once
// Zeros so near to a corner that no block fits between: the corner absorbs them, V becomes V + sum (V_k - 4).
//
// A zero no farther than `length` from a corner, with the segment between them in the domain, is absorbed when the new
// valence is admissible (guide/admissible_valence). Close to a tie both neighbouring valences are admissible, and the
// result is the count of quarter turns along an arc of radius `length`. Only corners of the layout absorb, smooth
// boundary points do not. A zero equally near to two corners is absorbed by neither; zeros equally near to one corner
// are absorbed together or not at all; nearer ones first. Equal is within 1e-6 of `length`.

#include <vector>

#include "model/critical_points.hpp"
#include "zeros/zero_search.hpp"

namespace quadrille::guide {

/// Changes `corners` and adds a change of the kind `absorb` for each that absorbs zeros. Returns which zeros were
/// absorbed.
std::vector<bool> absorb_into_corners(const field::FieldEvaluator& evaluator,
                                      const std::vector<zeros::FoundZero>& zeros, double length,
                                      std::vector<Corner>& corners, std::vector<NodeChange>& changes);

}  // namespace quadrille::guide
