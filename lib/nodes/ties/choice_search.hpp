#pragma once
// The zeros of the tilted field for one choice after another. A choice changes the field near a few corners only, so
// that most elements keep what was found in them for a *base*, the choice from which the others differ by little.
//
// An element without a zero keeps it as long as the field changes by less than the least |v| there. One with zeros
// keeps them where they are as long as none moves by more than tolerance::same_point, for what a choice costs does not
// depend on less; and it keeps their number, so that Newton's method finds their new places, as long as they stay far
// inside the cells in which they were isolated and the field changes by less than the least |v| elsewhere.

#include <optional>
#include <vector>

#include "ties/tilted_field.hpp"
#include "zeros/zero_search.hpp"

namespace quadrille::ties {

class ChoiceSearch {
 public:
  /// `tilted` must outlive the search. `noise` as for ZeroSearch.
  ChoiceSearch(TiltedField& tilted, double noise) : tilted_(tilted), noise_(noise) {}

  /// All zeros for a choice. The first choice becomes the base. Throws ComputeError if the search cannot decide.
  zeros::SearchResult zeros_of(const Choice& choice);

  /// Makes `choice` the base of the choices that follow. Throws as zeros_of.
  void set_base(const Choice& choice);

  /// How often an element was searched.
  long long num_searched() const { return num_searched_; }

 private:
  /// What was found for the base, or for a choice before that differs by less than a margin was then. Both margins are
  /// less what the base has changed since; negative: not searched yet.
  struct Known {
    zeros::SearchResult found;
    double margin = -1;  ///< below it nothing changes
    double reach = -1;   ///< below it zeros move
  };
  void renew(const Choice& choice);
  void search(int elem);
  std::optional<zeros::SearchResult> moved(int elem) const;
  double resting_margin(const zeros::SearchResult& found) const;
  Known known_of(int elem, zeros::SearchResult found);

  TiltedField& tilted_;
  double noise_;
  const field::FieldEvaluator* evaluator_ = nullptr;  ///< of tilted_
  std::optional<zeros::ZeroSearch> search_;
  std::optional<zeros::FarLiftings> liftings_;  ///< of the base
  Choice base_;                                 ///< empty before the first choice
  std::vector<Known> known_;                    ///< by element
  long long num_searched_ = 0;
};

}  // namespace quadrille::ties
