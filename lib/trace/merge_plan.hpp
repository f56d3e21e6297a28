#pragma once
// Which pairs of lines are merged, with second thoughts: merges that bend a line across its neighbour are given up, and
// lines that would go on for ever are merged whatever that turns.

#include <vector>

#include "trace/merge.hpp"

namespace quadrille::trace {

class MergePlan {
 public:
  /// `evaluator`, `lines` and `nodes` must outlive the plan. `reach` (a length): lines that have no end yet have been
  /// followed so far, and could be farther; 0: all are as long as they will be.
  MergePlan(const field::FieldEvaluator& evaluator, const std::vector<Streamline>& lines,
            const std::vector<Vec2>& nodes, const MergeOptions& options, double reach = 0);

  /// Candidates chosen, by the rules of merge.hpp among those not given up. Then every endless line (spiral, limit
  /// cycle) that has no partner takes the first free one that comes its way within greatest_merge_angle; where all are
  /// taken, the merge of two lines that end is given up for it.
  std::vector<int> choose();

  /// Gives up the candidates that turn most of these, within 1e-6 alike: a symmetry orbit together.
  /// False where none of them turns anything by more than `least_turn` (radians): nothing is given up then.
  bool give_up_worst(const std::vector<int>& candidates, double least_turn);

  /// Whether a choice would have needed longer lines: it is then not what the whole lines give.
  bool is_cut_short() const { return is_cut_short_; }

  const MergeCandidate& candidate(int i) const { return candidates_[i]; }

 private:
  void add_candidates(const MergeOptions& options);
  bool is_endless(int line) const;
  bool needs_longer_lines(const std::vector<int>& chosen) const;
  std::vector<int> lost_lines(const std::vector<int>& chosen) const;
  std::vector<int> choose_once();
  bool give_up_for(const std::vector<int>& lost, const std::vector<int>& chosen);

  const field::FieldEvaluator& evaluator_;
  const std::vector<Streamline>& lines_;
  const std::vector<Vec2>& nodes_;
  std::vector<MergeCandidate> candidates_;  // by the rules, then the last resorts of endless lines
  std::vector<bool> given_up_;
  size_t num_regular_ = 0;
  double reach_;
  bool is_cut_short_ = false;
};

}  // namespace quadrille::trace
