#pragma once
// Do critical points and field belong together?

#include "field/evaluate.hpp"
#include "model/critical_points.hpp"

namespace quadrille::trace {

/// Throws FormatError unless the index sum of `points` is that of the domain and the nodes are the field's own: of a
/// harmonic field its zeros (within 1e-6 of the diameter) and the face's corners; of a phase the nodes, corner
/// valences, boundary nodes and windings that it was solved for, in the same order, within 1e-9 of the diameter.
void check_nodes_match_field(const field::FieldEvaluator& evaluator, const CriticalPoints& points);

}  // namespace quadrille::trace
