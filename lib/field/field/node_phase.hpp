#pragma once
// The phase beside an irregular node (lib/method.md §8.7).
//
//   phi(z) = phi_0 + d arg(z - a) + O(|z - a|)   near a node a of index d = 4 - V:
//
// the cross has the direction alpha if 4 alpha = phi_0 + d alpha (mod 2 pi).

#include "field/evaluate.hpp"

namespace quadrille::field {

/// phi_0 of node `node` of a field of kind "phase" (field.phase.prescribed.nodes), radians, modulo 2 pi. Throws
/// FormatError if the node lies outside the mesh. Linear in the number of terms.
double node_phase(const FieldEvaluator& evaluator, int node);

}  // namespace quadrille::field
