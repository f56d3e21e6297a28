#pragma once
// The zeros of the tilted field for one choice after another. A choice decides near a few corners only, and most of
// what was found in an element for the best choice so far holds for the next one: a cell without a zero keeps none as
// long as the field differs by less than the least |v| there, and all zeros stay where they are as long as none moves
// by more than tolerance::same_point, for what a choice costs does not depend on less.

#include <optional>
#include <vector>

#include "ties/tilted_field.hpp"
#include "zeros/zero_search.hpp"

namespace quadrille::ties {

class ChoiceSearch {
 public:
  /// `tilted` must outlive the search. `noise` as for ZeroSearch.
  ChoiceSearch(TiltedField& tilted, double noise) : tilted_(tilted), noise_(noise) {}

  /// All zeros for a choice. Throws ComputeError if the search cannot decide.
  zeros::SearchResult zeros_of(const Choice& choice);

  /// Those that Newton's method finds (ZeroSearch::follow): mostly all, at a fraction of the cost.
  zeros::SearchResult likely_zeros_of(const Choice& choice);

  /// Compares those that follow with the last choice.
  void keep_last();

  /// How many cells were examined.
  long long num_examined() const { return num_examined_; }

 private:
  /// What was found in an element for a choice.
  struct Known {
    Choice choice;
    zeros::SearchResult found;
    zeros::KnownCells cells;
    double rest = -1;   ///< how much the field may differ from that of the choice before anything changes
    double change = 0;  ///< by how much it does now
  };
  void renew(const Choice& choice);
  Known known_now(int elem);
  double rest_of(const Known& known) const;

  TiltedField& tilted_;
  double noise_;
  const field::FieldEvaluator* evaluator_ = nullptr;  ///< of tilted_
  std::optional<zeros::ZeroSearch> search_;
  Choice choice_;             ///< the last; empty before the first
  std::vector<Known> known_;  ///< by element
  struct New {
    int elem;
    Known known;
  };
  std::vector<New> last_;  ///< what differs for the last choice
  long long num_examined_ = 0;
};

}  // namespace quadrille::ties
