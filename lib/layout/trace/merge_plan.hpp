#pragma once
// Chooses the pairs of lines that are merged, with corrections: merges that bend a line across its neighbour are
// rejected, and lines that would never end are merged with a larger deviation.

#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "trace/merge_candidates.hpp"

namespace quadrille::trace {

class MergePlan {
 public:
  /// `evaluator`, `lines` and `nodes` must outlive the plan. `reach`: the length to which lines without an end have
  /// been traced so far, if they can be continued; 0: all lines are complete.
  MergePlan(const field::FieldEvaluator& evaluator, const std::vector<Streamline>& lines,
            const std::vector<Vec2>& nodes, const MergeOptions& options, double reach = 0);

  /// Numbers of the candidates chosen by the rules (trace/merge_candidates.hpp, trace/choose_merges.hpp) among those
  /// not rejected.
  std::vector<int> choose_by_rules() const;

  /// choose_by_rules, then every endless line (spiral, limit cycle) without a partner is merged with the first free one
  /// that meets it head on within max_endless_merge_angle; if none is free, the merge of two lines that end is rejected
  /// for it. std::nullopt if continued lines might change the choice.
  std::optional<std::vector<int>> choose();

  /// The first line that cannot be continued (Streamline::is_stuck), is far shorter than the reach and has no partner
  /// by the rules; std::nullopt if every line can be continued, is long or has a partner. Continuing the other lines
  /// gives such a line no partner.
  std::optional<int> stuck_without_partner() const;

  /// Rejects those of these candidates whose deviation is within 1e-6 of the largest: a symmetry orbit together.
  /// Returns false and rejects none if the largest is below `least_deviation` (radians).
  bool reject_worst(const std::vector<int>& candidates, double least_deviation);

  /// Rejects all candidates of each pair of lines of which one is rejected.
  void reject_whole_pairs();

  /// Searches candidates again, after lines were added or continued; rejects all candidates of rejected pairs.
  void renew();

  const MergeCandidate& candidate(int i) const { return candidates_[i]; }
  /// The candidate among `chosen` of each line, or -1.
  std::vector<int> merge_of_lines(const std::vector<int>& chosen) const;

 private:
  using LinePairs = std::set<std::pair<int, int>>;

  void reject(const LinePairs& pairs);
  LinePairs rejected_pairs() const;
  void add_candidates(const MergeOptions& options);
  bool needs_longer_lines(const std::vector<int>& chosen) const;
  std::vector<int> endless_without_partner(const std::vector<int>& chosen) const;
  std::optional<std::vector<int>> choose_once();
  void add_last_resorts(const std::vector<int>& endless, std::vector<int>& chosen);
  bool reject_for(int endless, const std::vector<int>& merge_of);

  const field::FieldEvaluator& evaluator_;
  const std::vector<Streamline>& lines_;
  const std::vector<Vec2>& nodes_;
  MergeOptions options_;
  std::vector<MergeCandidate> candidates_;  // by the rules, then the last resorts of endless lines
  std::vector<bool> is_rejected_;
  size_t num_regular_ = 0;  // candidates by the rules
  double reach_;
};

}  // namespace quadrille::trace
