#pragma once
// Zeros too near to a corner for a block between: the corner absorbs them, and V becomes V + sum (V_k - 4).
//
// A zero no farther than `length` from a corner, with the segment between them in the domain, is absorbed if the new
// valence is admissible (guide/valence). Close to a tie both neighbouring valences are admissible, and the
// result is the count of quarter turns along an arc of radius `length`. Only corners of the layout absorb zeros, smooth
// boundary points do not, nor corners whose valence was chosen by rule (source `line`). A zero equally near to two
// corners is absorbed by neither; zeros equally near to one corner are absorbed together or not at all; nearer zeros
// are decided first. Distances within 1e-6 of `length` count as equal.

#include <vector>

#include "model/critical_points.hpp"
#include "zeros/zero_search.hpp"

namespace quadrille::guide {

/// Changes the corners of `points`, each with a change of the kind `absorb`. Returns for each zero whether it was
/// absorbed.
std::vector<bool> absorb_into_corners(const CadFace& face, const std::vector<zeros::FoundZero>& zeros, double length,
                                      CriticalPoints& points);

}  // namespace quadrille::guide
