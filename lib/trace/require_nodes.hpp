#pragma once
// Do critical points and field belong together?

#include "field/evaluate.hpp"
#include "model/critical_points.hpp"

namespace quadrille {

/// Throws FormatError unless the irregular nodes of `points` are zeros of the field (within 1e-6 of the diameter), its
/// corners those of the face and its index sum that of the domain.
void require_nodes_of_field(const FieldEvaluator& evaluator, const CriticalPoints& points);

}  // namespace quadrille
