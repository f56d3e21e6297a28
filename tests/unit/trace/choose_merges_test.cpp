#include "trace/choose_merges.hpp"

#include <gtest/gtest.h>

namespace quadrille::trace {
namespace {

MergeCandidate pair(int a, int b, double length) { return {a, b, length, length, 0, 0}; }

std::vector<int> choose(const std::vector<MergeCandidate>& all, const std::vector<bool>& allowed) {
  std::vector<bool> taken(5, false);
  return choose_merges(all, allowed, taken);
}

TEST(ChooseMerges, TakesTheFirstMeetingOfALine) {
  const std::vector<MergeCandidate> all{pair(0, 1, 1), pair(1, 2, 2), pair(2, 3, 3)};
  EXPECT_EQ(choose(all, {true, true, true}), (std::vector<int>{0, 2}));
  EXPECT_EQ(choose(all, {false, true, true}), (std::vector<int>{1}));
}

TEST(ChooseMerges, DecidesTiesOfAnOrbitAlike) {
  // Line 0 could go either way at the same time: neither, and the later meeting of 1 and 2 is free.
  const std::vector<MergeCandidate> all{pair(0, 1, 1), pair(0, 2, 1 + 1e-9), pair(3, 4, 1 + 1e-9), pair(1, 2, 2)};
  EXPECT_EQ(choose(all, {true, true, true, true}), (std::vector<int>{2, 3}));
}

TEST(ChooseMerges, APairThatBendsWaitsForOneThatFits) {
  MergeCandidate bent = pair(0, 1, 1);
  bent.deviation = 0.2;
  EXPECT_GT(bent.delayed_meeting(), pair(1, 2, 1.1).delayed_meeting());
  EXPECT_LT(bent.delayed_meeting(), pair(1, 2, 1.3).delayed_meeting());
  EXPECT_EQ(choose({pair(1, 2, 1.1), bent, pair(0, 3, 1.25)}, {true, true, true}), (std::vector<int>{0, 2}));
}

}  // namespace
}  // namespace quadrille::trace
