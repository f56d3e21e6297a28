#include "field/node_phase.hpp"

#include "base/error.hpp"
#include "field/phase_value.hpp"
#include "spectral/orthogonal_basis.hpp"

namespace quadrille::field {

double node_phase(const FieldEvaluator& evaluator, int node) {
  const Field& field = evaluator.field();
  PhaseTerms others = field.phase.terms;
  const Vec2 x = others.nodes.at(node).position;
  others.nodes[node].turns = 0;
  const mesh::Location at = evaluator.locator().find(x);
  if (at.elem < 0) throw FormatError("an irregular node lies outside the field's mesh");
  const double* s = &field.phase.s[field.coef_offsets[at.elem]];
  return spectral::orthogonal_sum(field.elem_order[at.elem], s, s, at.xi).x + explicit_phase(others, x);
}

}  // namespace quadrille::field
