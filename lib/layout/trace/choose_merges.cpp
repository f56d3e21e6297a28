#include "trace/choose_merges.hpp"

namespace quadrille::trace {
namespace {

constexpr double relative_tie = 1e-6;  // lengths that differ by less are equal

// Picks among the candidates first ... last - 1, whose fronts meet at equal lengths.
// `num_competing`: 0 for every line, before and afterwards.
void choose_tied(const std::vector<MergeCandidate>& candidates, const std::vector<bool>& allowed, size_t first,
                 size_t last, std::vector<bool>& is_taken, std::vector<int>& num_competing, std::vector<int>& chosen) {
  std::vector<int> free;
  for (size_t i = first; i < last; ++i) {
    const MergeCandidate& c = candidates[i];
    if (!allowed[i] || is_taken[c.a] || is_taken[c.b]) continue;
    free.push_back(static_cast<int>(i));
    ++num_competing[c.a], ++num_competing[c.b];
  }
  for (const int i : free) {
    const MergeCandidate& c = candidates[i];
    if (num_competing[c.a] > 1 || num_competing[c.b] > 1) continue;
    is_taken[c.a] = is_taken[c.b] = true;
    chosen.push_back(i);
  }
  for (const int i : free) num_competing[candidates[i].a] = num_competing[candidates[i].b] = 0;
}

}  // namespace

std::vector<int> choose_merges(const std::vector<MergeCandidate>& candidates, const std::vector<bool>& allowed,
                               std::vector<bool>& is_taken) {
  std::vector<int> chosen, num_competing(is_taken.size(), 0);
  for (size_t first = 0, last = 0; first < candidates.size(); first = last) {
    const double same = candidates[first].delayed_meeting() * (1 + relative_tie);
    while (last < candidates.size() && candidates[last].delayed_meeting() <= same) ++last;
    choose_tied(candidates, allowed, first, last, is_taken, num_competing, chosen);
  }
  return chosen;
}

}  // namespace quadrille::trace
