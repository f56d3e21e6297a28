#include "ties/choice_search.hpp"

#include <algorithm>
#include <utility>

#include "base/tolerance.hpp"
#include "zeros/cell.hpp"
#include "zeros/enclosure.hpp"

namespace quadrille::ties {
namespace {

/// A zero may move as far inside the cell that isolated it, in radii of the cell: to first order, and as found.
constexpr double greatest_move = 0.1, greatest_found_move = 0.25;

double inverse_slope(const field::FieldEvaluator& evaluator, const zeros::FoundZero& zero) {
  return zeros::frobenius_norm(inverse(evaluator.sample(zero.elem, zero.xi).dv_dx));
}

}  // namespace

zeros::SearchResult ChoiceSearch::zeros_of(const Choice& choice) {
  if (base_.empty()) set_base(choice);
  renew(choice);
  const std::vector<double> changes = tilted_.changes(base_, choice);
  for (std::size_t e = 0; e < changes.size() && !search_->is_budget_exhausted(); ++e) {
    const int elem = static_cast<int>(e);
    if (changes[e] <= known_[e].margin)
      search_->add(known_[e].found);
    else if (const auto there = changes[e] <= known_[e].reach ? moved(elem) : std::nullopt)
      search_->add(*there);
    else
      search(elem);
  }
  zeros::require_decided(*search_, evaluator_->field().mesh.face.origin);
  return search_->take();
}

void ChoiceSearch::set_base(const Choice& choice) {
  renew(choice);
  if (liftings_)
    liftings_->renew();
  else
    liftings_.emplace(*evaluator_);
  const Choice before = std::exchange(base_, choice);
  known_.resize(evaluator_->field().mesh.num_elems());
  const std::vector<double> changes = tilted_.changes(before.empty() ? choice : before, choice);
  for (std::size_t e = 0; e < changes.size(); ++e) {
    const int elem = static_cast<int>(e);
    Known& known = known_[e];
    known.margin -= changes[e];
    known.reach -= changes[e];
    if (known.margin >= 0) continue;
    if (auto there = known.reach >= 0 ? moved(elem) : std::nullopt) {
      known.margin = std::min(known.reach, resting_margin(*there));
      known.found = std::move(*there);
      continue;
    }
    search(elem);
    zeros::require_decided(*search_, evaluator_->field().mesh.face.origin);
    known = known_of(elem, search_->take());
  }
}

void ChoiceSearch::renew(const Choice& choice) {
  evaluator_ = &tilted_.with(choice);
  if (search_)
    search_->renew();
  else
    search_.emplace(*evaluator_, std::vector<zeros::Disc>(), noise_);
}

void ChoiceSearch::search(int elem) {
  ++num_searched_;
  search_->search(elem);
}

/// What is known of the element with its zeros where they are now; nothing if one is not near where it was.
std::optional<zeros::SearchResult> ChoiceSearch::moved(int elem) const {
  zeros::SearchResult there = known_[elem].found;
  for (zeros::FoundZero& zero : there.zeros) {
    if (!zeros::polish_zero(*evaluator_, elem, zero.xi)) return {};
    const field::FieldSample s = evaluator_->sample(elem, zero.xi);
    const bool is_near = distance(s.x, zero.x) <= greatest_found_move * zero.cell_radius;
    if (!is_near || det(s.dv_dx) * zero.index <= 0) return {};
    zero.x = s.x;
  }
  return there;
}

/// The change of the field that moves no zero by more than tolerance::same_point.
double ChoiceSearch::resting_margin(const zeros::SearchResult& found) const {
  double margin = 1;
  for (const zeros::FoundZero& zero : found.zeros)
    margin = std::min(
        margin, tolerance::same_point * evaluator_->field().mesh.face.diameter / inverse_slope(*evaluator_, zero));
  return margin;
}

ChoiceSearch::Known ChoiceSearch::known_of(int elem, zeros::SearchResult found) {
  Known known{std::move(found), 0, 0};
  if (!known.found.open_cells.empty() || evaluator_->field().method != FieldMethod::cg) return known;
  std::vector<zeros::Disc> discs;
  for (const zeros::FoundZero& zero : known.found.zeros) discs.push_back({zero.x, zero.cell_radius});
  known.reach = zeros::least_value(*evaluator_, *liftings_, elem, discs);
  for (const zeros::FoundZero& zero : known.found.zeros)
    known.reach = std::min(known.reach, greatest_move * zero.cell_radius / inverse_slope(*evaluator_, zero));
  known.margin = discs.empty() ? known.reach : resting_margin(known.found);
  known.reach = std::max(known.reach, known.margin);
  return known;
}

}  // namespace quadrille::ties
