#pragma once
// The zeros of the tilted field for one choice after another. A choice changes the field near a few corners only, so
// that most elements keep what was found in them for a *base*, the choice from which the others differ by little.
//
// An element keeps it as long as the field changes by less than its margin: without a zero, the least |v| there; with
// zeros, what moves none of them by more than tolerance::same_point. What a choice costs does not depend on less.

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

 private:
  /// What was found for the base, or for a choice before that differs by less than the margin was then.
  struct Known {
    zeros::SearchResult found;
    double margin = -1;  ///< less what the base has changed since; negative: not searched yet
  };
  double margin_of(const field::FieldEvaluator& evaluator, zeros::FarLiftings& liftings, int elem,
                   const zeros::SearchResult& found) const;

  TiltedField& tilted_;
  double noise_;
  Choice base_;               ///< empty before the first choice
  std::vector<Known> known_;  ///< by element
};

}  // namespace quadrille::ties
