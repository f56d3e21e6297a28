#pragma once
// The zeros of the tilted field for one choice after another. A choice decides near a few corners only, so that most
// elements keep what was found in them for a choice before: for the last, or for one that decided alike near them.
//
// An element without a zero keeps it as long as the field differs by less than the least |v| there. One with zeros
// keeps their number, so that Newton's method finds their new places, as long as they stay far inside the cells in
// which they were isolated and the field differs by less than the least |v| elsewhere; and it keeps them where they are
// as long as none moves by more than tolerance::same_point, for what a choice costs does not depend on less.

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

  /// Spends more on what was found for the last choice, so that it holds for more of those that follow.
  void keep_last();

  /// How often an element was searched.
  long long num_searched() const { return num_searched_; }

 private:
  /// What was found in an element for a choice.
  struct Known {
    Choice choice;
    zeros::SearchResult found, there;  ///< for that choice, and with the zeros where they were seen last
    double reach = 0;                  ///< how much the field may differ from that of the choice
    bool is_kept = false;              ///< whether the reach is as great as can be had
    double change = 0;                 ///< by how much it does now
    double rest = 0;                   ///< how much more it may change before zeros move
  };
  void renew(const Choice& choice);
  const Known* known_now(int elem);
  std::optional<zeros::SearchResult> moved(int elem, zeros::SearchResult found) const;
  double resting_margin(const zeros::SearchResult& found) const;
  Known known_of(const zeros::SearchResult& found) const;
  double greatest_reach(int elem, const zeros::SearchResult& found);

  TiltedField& tilted_;
  double noise_;
  const field::FieldEvaluator* evaluator_ = nullptr;  ///< of tilted_
  std::optional<zeros::ZeroSearch> search_;
  Choice choice_;                          ///< the last; empty before the first
  std::vector<std::vector<Known>> known_;  ///< by element, the one that held last first
  long long num_searched_ = 0;
};

}  // namespace quadrille::ties
