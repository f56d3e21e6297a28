#include "trace/merge_plan.hpp"

#include <algorithm>

#include "trace/choose_merges.hpp"

namespace quadrille::trace {
namespace {

constexpr double same_deviation = 1e-6;  // radians

// A pair that is not known yet has a line longer than the reach. Lengths of a pair are so nearly equal
// (trace/merge_candidates.cpp) that their mean is then above this fraction of the reach: pairs below are chosen before
// it in any case.
constexpr double settled_fraction = 0.85;

}  // namespace

MergePlan::MergePlan(const field::FieldEvaluator& evaluator, const std::vector<Streamline>& lines,
                     const std::vector<Vec2>& nodes, const MergeOptions& options, double reach)
    : evaluator_(evaluator), lines_(lines), nodes_(nodes), options_(options), reach_(reach) {
  add_candidates(options);
  num_regular_ = candidates_.size();
}

void MergePlan::add_candidates(const MergeOptions& options) {
  for (const MergeCandidate& c : merge_candidates(evaluator_, lines_, nodes_, options)) candidates_.push_back(c);
  is_rejected_.resize(candidates_.size(), false);
}

// Ascending.
std::vector<int> MergePlan::endless_without_partner(const std::vector<int>& chosen) const {
  const std::vector<int> merge_of = merge_of_lines(chosen);
  std::vector<int> endless;
  for (int i = 0; i < static_cast<int>(lines_.size()); ++i)
    if (lines_[i].is_endless() && merge_of[i] < 0) endless.push_back(i);
  return endless;
}

bool MergePlan::needs_longer_lines(const std::vector<int>& chosen) const {
  if (reach_ == 0) return false;
  const auto may_be_late = [this](int c) {
    const MergeCandidate& pair = candidates_[c];
    return pair.delayed_meeting() > settled_fraction * reach_ &&
           (lines_[pair.a].is_endless() || lines_[pair.b].is_endless());
  };
  return !endless_without_partner(chosen).empty() || std::any_of(chosen.begin(), chosen.end(), may_be_late);
}

std::vector<int> MergePlan::choose_by_rules() const {
  std::vector<bool> is_taken(lines_.size(), false), allowed(candidates_.size(), false);
  for (size_t i = 0; i < num_regular_; ++i) allowed[i] = !is_rejected_[i];
  return choose_merges(candidates_, allowed, is_taken);
}

std::optional<std::vector<int>> MergePlan::choose_once() {
  std::vector<int> chosen = choose_by_rules();
  if (needs_longer_lines(chosen)) return std::nullopt;
  const std::vector<int> endless = endless_without_partner(chosen);
  if (!endless.empty()) add_last_resorts(endless, chosen);
  return chosen;
}

void MergePlan::add_last_resorts(const std::vector<int>& endless, std::vector<int>& chosen) {
  if (candidates_.size() == num_regular_) add_candidates({max_endless_merge_angle, 0, true});
  const auto needs_partner = [&](int line) { return std::binary_search(endless.begin(), endless.end(), line); };
  std::vector<bool> allowed(candidates_.size(), false), is_taken(lines_.size(), false);
  for (const int c : chosen) is_taken[candidates_[c].a] = is_taken[candidates_[c].b] = true;
  for (size_t i = num_regular_; i < candidates_.size(); ++i)
    allowed[i] = !is_rejected_[i] && (needs_partner(candidates_[i].a) || needs_partner(candidates_[i].b));
  for (const int c : choose_merges(candidates_, allowed, is_taken)) chosen.push_back(c);
}

// Rejects the merge that occupies the first partner of an endless line, if both merged lines end. True if it was not
// rejected before.
bool MergePlan::reject_for(int endless, const std::vector<int>& merge_of) {
  for (size_t i = 0; i < candidates_.size(); ++i) {
    const MergeCandidate& pair = candidates_[i];
    if (is_rejected_[i] || (pair.a != endless && pair.b != endless)) continue;
    const int other = merge_of[pair.a == endless ? pair.b : pair.a];
    if (other < 0 || lines_[candidates_[other].a].is_endless() || lines_[candidates_[other].b].is_endless()) continue;
    const bool is_new = !is_rejected_[other];
    is_rejected_[other] = true;
    return is_new;
  }
  return false;
}

std::optional<std::vector<int>> MergePlan::choose() {
  std::optional<std::vector<int>> chosen = choose_once();
  // Every round rejects a candidate permanently, so the loop ends.
  while (chosen) {
    const std::vector<int> merge_of = merge_of_lines(*chosen);
    bool any = false;
    for (const int line : endless_without_partner(*chosen)) any = reject_for(line, merge_of) || any;
    if (!any) break;
    chosen = choose_once();
  }
  return chosen;
}

// The two lengths of a pair differ so little (trace/merge_candidates.cpp) that all pairs of such a line are known.
std::optional<int> MergePlan::stuck_without_partner() const {
  for (const int line : endless_without_partner(choose_by_rules()))
    if (lines_[line].is_stuck() && 2 * lines_[line].length() < reach_) return line;
  return std::nullopt;
}

bool MergePlan::reject_worst(const std::vector<int>& candidates, double least_deviation) {
  double worst = -1;
  for (const int c : candidates) worst = std::max(worst, candidates_[c].deviation);
  if (worst < least_deviation) return false;
  for (const int c : candidates)
    if (candidates_[c].deviation > worst - same_deviation) is_rejected_[c] = true;
  return true;
}

void MergePlan::reject_whole_pairs() { reject(rejected_pairs()); }

void MergePlan::renew() {
  const LinePairs pairs = rejected_pairs();
  candidates_.clear();
  is_rejected_.clear();
  add_candidates(options_);
  num_regular_ = candidates_.size();
  reject(pairs);
}

void MergePlan::reject(const LinePairs& pairs) {
  for (size_t i = 0; i < candidates_.size(); ++i)
    if (pairs.count({candidates_[i].a, candidates_[i].b}) > 0) is_rejected_[i] = true;
}

MergePlan::LinePairs MergePlan::rejected_pairs() const {
  LinePairs pairs;
  for (size_t i = 0; i < candidates_.size(); ++i)
    if (is_rejected_[i]) pairs.insert({candidates_[i].a, candidates_[i].b});
  return pairs;
}

std::vector<int> MergePlan::merge_of_lines(const std::vector<int>& chosen) const {
  std::vector<int> merge_of(lines_.size(), -1);
  for (const int c : chosen) merge_of[candidates_[c].a] = merge_of[candidates_[c].b] = c;
  return merge_of;
}

}  // namespace quadrille::trace
