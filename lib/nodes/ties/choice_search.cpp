#include "ties/choice_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/tolerance.hpp"
#include "zeros/cell.hpp"
#include "zeros/enclosure.hpp"

namespace quadrille::ties {
namespace {

/// Of an element: beyond that the one that held longest ago is forgotten.
constexpr std::size_t most_known = 16;

/// What differs by less is one field.
constexpr double same_field = 1e-12;

/// A zero may move as far inside the cell that isolated it, in radii of the cell: to first order, and as found.
constexpr double greatest_move = 0.1, greatest_found_move = 0.25;

double inverse_slope(const field::FieldEvaluator& evaluator, const zeros::FoundZero& zero) {
  return zeros::frobenius_norm(inverse(evaluator.sample(zero.elem, zero.xi).dv_dx));
}

}  // namespace

zeros::SearchResult ChoiceSearch::zeros_of(const Choice& choice) {
  renew(choice);
  const Vec2 origin = evaluator_->field().mesh.face.origin;
  std::vector<zeros::SearchResult> found;
  for (int elem = 0; elem < evaluator_->field().mesh.num_elems(); ++elem) {
    if (const Known* known = known_now(elem)) {
      found.push_back(known->there);
      continue;
    }
    ++num_searched_;
    search_->search(elem);
    zeros::require_decided(*search_, origin);
    found.push_back(search_->take());
    std::vector<Known>& known = known_[elem];
    known.insert(known.begin(), known_of(found.back()));
    if (known.size() > most_known) known.pop_back();
  }
  for (const zeros::SearchResult& there : found) search_->add(there);
  zeros::require_decided(*search_, origin);
  return search_->take();
}

void ChoiceSearch::renew(const Choice& choice) {
  evaluator_ = &tilted_.with(choice);
  if (!search_) {
    search_.emplace(*evaluator_, std::vector<zeros::Disc>(), noise_);
    known_.resize(evaluator_->field().mesh.num_elems());
  } else {
    search_->renew();
    for (std::size_t u = 0; u < choice.size(); ++u) {
      if (choice[u] == choice_[u]) continue;
      for (const auto& [elem, change] : tilted_.changes(u))
        for (Known& known : known_[elem]) {
          known.change += choice[u] == known.choice[u] ? -change : change;
          known.rest -= change;
        }
    }
  }
  choice_ = choice;
}

/// What was found that still holds, with zeros where they are now; null if nothing is.
const ChoiceSearch::Known* ChoiceSearch::known_now(int elem) {
  for (auto known = known_[elem].begin(); known != known_[elem].end(); ++known) {
    if (known->change > known->reach) continue;
    if (known->rest < 0) {
      auto there = moved(elem, known->found);
      if (!there) continue;
      known->rest = resting_margin(*there);
      known->there = std::move(*there);
    }
    std::rotate(known_[elem].begin(), known, known + 1);
    return &known_[elem].front();
  }
  return nullptr;
}

/// With the zeros where they are now; nothing if one is not near where it was.
std::optional<zeros::SearchResult> ChoiceSearch::moved(int elem, zeros::SearchResult found) const {
  for (zeros::FoundZero& zero : found.zeros) {
    if (!zeros::polish_zero(*evaluator_, elem, zero.xi)) return {};
    const field::FieldSample s = evaluator_->sample(elem, zero.xi);
    const bool is_near = distance(s.x, zero.x) <= greatest_found_move * zero.cell_radius;
    if (!is_near || det(s.dv_dx) * zero.index <= 0) return {};
    zero.x = s.x;
  }
  return found;
}

/// The change of the field that moves no zero by more than tolerance::same_point.
double ChoiceSearch::resting_margin(const zeros::SearchResult& found) const {
  double margin = INFINITY;
  for (const zeros::FoundZero& zero : found.zeros)
    margin = std::min(
        margin, tolerance::same_point * evaluator_->field().mesh.face.diameter / inverse_slope(*evaluator_, zero));
  return margin;
}

/// Most choices are no better than the best so far, and are not met again: their reach is what costs nothing.
ChoiceSearch::Known ChoiceSearch::known_of(const zeros::SearchResult& found) const {
  Known known{choice_, found, found};
  known.rest = resting_margin(found);
  if (!found.open_cells.empty() || evaluator_->field().method != FieldMethod::cg) {
    known.is_kept = true;
  } else if (found.counts.isolated == 0) {
    known.reach = found.least_excluded;
  } else {
    known.reach = same_field;
  }
  return known;
}

double ChoiceSearch::greatest_reach(int elem, const zeros::SearchResult& found) {
  std::vector<zeros::Disc> discs;
  double reach = INFINITY;
  for (const zeros::FoundZero& zero : found.zeros) {
    discs.push_back({zero.x, zero.cell_radius});
    reach = std::min(reach, greatest_move * zero.cell_radius / inverse_slope(*evaluator_, zero));
  }
  return std::min(reach, zeros::least_value(*evaluator_, search_->liftings(), elem, discs, reach));
}

void ChoiceSearch::keep_last() {
  for (std::size_t elem = 0; elem < known_.size(); ++elem)
    for (Known& known : known_[elem]) {
      if (known.is_kept || known.change > same_field) continue;
      known.is_kept = true;
      known.reach = std::max(known.reach, greatest_reach(static_cast<int>(elem), known.there));
    }
}

}  // namespace quadrille::ties
