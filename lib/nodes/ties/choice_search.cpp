#include "ties/choice_search.hpp"

#include <algorithm>
#include <utility>

#include "base/tolerance.hpp"
#include "zeros/enclosure.hpp"

namespace quadrille::ties {

zeros::SearchResult ChoiceSearch::zeros_of(const Choice& choice) {
  renew(choice);
  const TriMesh& mesh = evaluator_->field().mesh;
  for (int elem = 0; elem < mesh.num_elems(); ++elem)
    if (known_[elem].change > known_[elem].rest) last_.push_back({elem, known_now(elem)});
  auto next = last_.begin();
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const bool is_new = next != last_.end() && next->elem == elem;
    search_->add(is_new ? (next++)->known.found : known_[elem].found);
  }
  zeros::require_decided(*search_, mesh.face);
  return search_->take();
}

zeros::SearchResult ChoiceSearch::likely_zeros_of(const Choice& choice) {
  renew(choice);
  for (int elem = 0; elem < std::ssize(known_); ++elem) {
    const Known& known = known_[elem];
    if (known.change > known.rest)
      search_->follow(elem, known.found.zeros);
    else
      search_->add(known.found);
  }
  return search_->take();
}

void ChoiceSearch::renew(const Choice& choice) {
  evaluator_ = &tilted_.with(choice);
  last_.clear();
  if (!search_) {
    search_.emplace(*evaluator_, std::vector<zeros::Disc>(), noise_);
    known_.assign(evaluator_->field().mesh.num_elems(), Known{choice, {}, {}});
  } else {
    search_->renew();
    for (std::size_t u = 0; u < choice.size(); ++u) {
      if (choice[u] == choice_[u]) continue;
      for (const auto& [elem, change] : tilted_.changes(u)) {
        Known& known = known_[elem];
        known.change += choice[u] == known.choice[u] ? -change : change;
      }
    }
  }
  choice_ = choice;
}

ChoiceSearch::Known ChoiceSearch::known_now(int elem) {
  const Known& before = known_[elem];
  // The jumps of a discontinuous field are not bounded by its changes.
  const bool is_continuous = evaluator_->field().method == FieldMethod::cg;
  Known now{choice_, {}, is_continuous ? before.cells : zeros::KnownCells()};
  search_->search(elem, before.change, now.cells);
  zeros::require_decided(*search_, evaluator_->field().mesh.face);
  now.found = search_->take();
  num_examined_ += now.found.counts.examined;
  now.rest = is_continuous ? rest_of(now) : 0;
  return now;
}

/// The change of the field that brings no other zero, and moves none by more than tolerance::same_point.
double ChoiceSearch::rest_of(const Known& known) const {
  if (known.found.counts.isolated == 0) return known.cells.front().least;
  if (std::ssize(known.found.zeros) < known.found.counts.isolated || !known.found.open_cells.empty()) return 0;
  double rest = INFINITY;
  for (const zeros::KnownCell& cell : known.cells)
    if (cell.least > 0) rest = std::min(rest, cell.least);
  for (const zeros::FoundZero& zero : known.found.zeros) {
    const Mat2 slope = evaluator_->sample(zero.elem, zero.xi).dv_dx;
    rest = std::min(
        rest, tolerance::same_point * evaluator_->field().mesh.face.diameter / zeros::frobenius_norm(inverse(slope)));
  }
  return rest;
}

void ChoiceSearch::keep_last() {
  for (auto& [elem, known] : last_) known_[elem] = std::move(known);
  last_.clear();
}

}  // namespace quadrille::ties
