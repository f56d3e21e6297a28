#include "trace/merge_plan.hpp"

#include <algorithm>

namespace quadrille::trace {

MergePlan::MergePlan(const field::FieldEvaluator& evaluator, const std::vector<Streamline>& lines,
                     const std::vector<Vec2>& nodes, const MergeOptions& options, double reach)
    : evaluator_(evaluator), lines_(lines), nodes_(nodes), reach_(reach) {
  add_candidates(options);
  num_regular_ = candidates_.size();
}

void MergePlan::add_candidates(const MergeOptions& options) {
  for (const MergeCandidate& c : merge_candidates(evaluator_, lines_, nodes_, options)) candidates_.push_back(c);
  given_up_.resize(candidates_.size(), false);
}

bool MergePlan::is_endless(int line) const { return lines_[line].end == Streamline::End::length; }

// Endless lines that no merge has taken, ascending.
std::vector<int> MergePlan::lost_lines(const std::vector<int>& chosen) const {
  std::vector<bool> merged(lines_.size(), false);
  for (const int c : chosen) merged[candidates_[c].a] = merged[candidates_[c].b] = true;
  std::vector<int> lost;
  for (int i = 0; i < static_cast<int>(lines_.size()); ++i)
    if (is_endless(i) && !merged[i]) lost.push_back(i);
  return lost;
}

// A pair that is not known yet has a line longer than the reach, and lengths so unequal are no pair that its mean is
// above 0.85 of it: pairs below are chosen before it, whatever else there is.
bool MergePlan::needs_longer_lines(const std::vector<int>& chosen) const {
  if (reach_ == 0) return false;
  const auto may_be_late = [this](int c) {
    const MergeCandidate& pair = candidates_[c];
    return pair.meeting() > 0.85 * reach_ && (is_endless(pair.a) || is_endless(pair.b));
  };
  return !lost_lines(chosen).empty() || std::any_of(chosen.begin(), chosen.end(), may_be_late);
}

std::vector<int> MergePlan::choose_once() {
  std::vector<bool> taken(lines_.size(), false), allowed(candidates_.size(), false);
  for (size_t i = 0; i < num_regular_; ++i) allowed[i] = !given_up_[i];
  std::vector<int> chosen = choose_merges(candidates_, allowed, taken);
  is_cut_short_ = is_cut_short_ || needs_longer_lines(chosen);
  const std::vector<int> lost = lost_lines(chosen);
  if (lost.empty() || is_cut_short_) return chosen;
  if (candidates_.size() == num_regular_) add_candidates({greatest_merge_angle, 0, true});
  const auto is_lost = [&](int line) { return std::binary_search(lost.begin(), lost.end(), line); };
  allowed.assign(candidates_.size(), false);
  for (size_t i = num_regular_; i < candidates_.size(); ++i)
    allowed[i] = !given_up_[i] && (is_lost(candidates_[i].a) || is_lost(candidates_[i].b));
  for (const int c : choose_merges(candidates_, allowed, taken)) chosen.push_back(c);
  return chosen;
}

bool MergePlan::give_up_for(const std::vector<int>& lost, const std::vector<int>& chosen) {
  std::vector<int> merge_of(lines_.size(), -1);
  for (const int c : chosen) merge_of[candidates_[c].a] = merge_of[candidates_[c].b] = c;
  bool any = false;
  for (const int line : lost)
    for (size_t i = 0; i < candidates_.size(); ++i) {
      const MergeCandidate& wish = candidates_[i];
      if (given_up_[i] || (wish.a != line && wish.b != line)) continue;
      const int taker = merge_of[wish.a == line ? wish.b : wish.a];
      if (taker < 0 || is_endless(candidates_[taker].a) || is_endless(candidates_[taker].b)) continue;
      any = any || !given_up_[taker];
      given_up_[taker] = true;
      break;
    }
  return any;
}

std::vector<int> MergePlan::choose() {
  std::vector<int> chosen = choose_once();
  if (is_cut_short_) return chosen;
  // Every round gives up a candidate for good, so this ends.
  for (auto lost = lost_lines(chosen); !lost.empty() && give_up_for(lost, chosen); lost = lost_lines(chosen))
    chosen = choose_once();
  return chosen;
}

bool MergePlan::give_up_worst(const std::vector<int>& candidates, double least_turn) {
  double turn = -1;
  for (const int c : candidates) turn = std::max(turn, candidates_[c].turn);
  if (turn < least_turn) return false;
  for (const int c : candidates)
    if (candidates_[c].turn > turn - 1e-6) given_up_[c] = true;
  return true;
}

}  // namespace quadrille::trace
