#include "ties/choice_search.hpp"

#include <algorithm>
#include <utility>

#include "base/tolerance.hpp"
#include "zeros/cell.hpp"
#include "zeros/enclosure.hpp"

namespace quadrille::ties {

zeros::SearchResult ChoiceSearch::zeros_of(const Choice& choice) {
  if (base_.empty()) set_base(choice);
  const field::FieldEvaluator& evaluator = tilted_.with(choice);
  const std::vector<double> changes = tilted_.changes(base_, choice);
  zeros::ZeroSearch search(evaluator, {}, noise_);
  for (std::size_t e = 0; e < changes.size() && !search.is_budget_exhausted(); ++e)
    if (tilted_.is_empty()[e])
      search.skip();
    else if (changes[e] <= known_[e].margin)
      search.add(known_[e].found);
    else
      search.search(static_cast<int>(e));
  zeros::require_decided(search, evaluator.field().mesh.face.origin);
  return search.take();
}

void ChoiceSearch::set_base(const Choice& choice) {
  const field::FieldEvaluator& evaluator = tilted_.with(choice);
  const Choice before = std::exchange(base_, choice);
  known_.resize(evaluator.field().mesh.num_elems());
  const std::vector<double> changes = tilted_.changes(before.empty() ? choice : before, choice);
  zeros::ZeroSearch search(evaluator, {}, noise_);
  zeros::FarLiftings liftings(evaluator);
  for (std::size_t e = 0; e < changes.size(); ++e) {
    Known& known = known_[e];
    if (tilted_.is_empty()[e]) continue;
    known.margin -= changes[e];
    if (known.margin >= 0) continue;
    search.search(static_cast<int>(e));
    zeros::require_decided(search, evaluator.field().mesh.face.origin);
    known.found = search.take();
    known.margin = margin_of(evaluator, liftings, static_cast<int>(e), known.found);
  }
}

double ChoiceSearch::margin_of(const field::FieldEvaluator& evaluator, zeros::FarLiftings& liftings, int elem,
                               const zeros::SearchResult& found) const {
  const Field& field = evaluator.field();
  if (!found.open_cells.empty() || field.method != FieldMethod::cg) return 0;
  if (found.zeros.empty()) return zeros::least_value(evaluator, liftings, elem);
  double margin = 1;
  for (const zeros::FoundZero& zero : found.zeros) {
    const Mat2 inverse_jacobian = inverse(evaluator.sample(elem, zero.xi).dv_dx);
    margin =
        std::min(margin, tolerance::same_point * field.mesh.face.diameter / zeros::frobenius_norm(inverse_jacobian));
  }
  return margin;
}

}  // namespace quadrille::ties
