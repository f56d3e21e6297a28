#pragma once
// Checks that critical points belong to a field.

#include "base/error.hpp"
#include "field/evaluate.hpp"
#include "model/critical_points.hpp"

namespace quadrille::field {

/// Nodes that the field does not have: solved for them (fieldsolve --nodes), it has.
struct OtherNodesError : FormatError {
  using FormatError::FormatError;
};

/// Throws FormatError unless the index sum of `points` is the index sum of the domain and the nodes are those of the
/// field: for a harmonic field its zeros (within 1e-6 of the diameter) and the face's corners; for a phase the nodes,
/// corner valences, boundary nodes and hole windings that it was solved for, in the same order, within 1e-9 of the
/// diameter; OtherNodesError where these differ.
void check_nodes_match_field(const FieldEvaluator& evaluator, const CriticalPoints& points);

}  // namespace quadrille::field
