#include "sizing/error_counts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace quadrille::sizing {
namespace {

int as_asked(int, int count) { return count; }

/// One block of 20 x 20 elements.
ErrorParts one_block(double first_part) {
  return {{first_part, 1 - first_part}, {20, 20}, {false, false}, {{0, 1}}, 400};
}

TEST(ErrorCounts, TheChordWithTheGreaterPartGetsMoreElementsFirst) {
  const std::vector<CountStep> steps = count_steps(one_block(9.0 / 13), as_asked, 0);
  ASSERT_EQ(steps.size(), 4U);
  EXPECT_EQ(steps[0].counts, (std::vector<int>{20, 19}));
  EXPECT_EQ(steps[1].counts, (std::vector<int>{21, 20}));
  EXPECT_EQ(steps[2].counts, (std::vector<int>{20, 21}));
  EXPECT_EQ(steps[3].counts, (std::vector<int>{19, 20}));
  const double sum = 9.0 / 13 + 4.0 / 13 / (0.95 * 0.95);
  EXPECT_NEAR(steps[0].cost, 4 * std::log(sum * 0.95), 1e-12);
}

TEST(ErrorCounts, StepsChangeAPartOfTheCount) {
  const std::vector<CountStep> steps = count_steps(one_block(0.55), as_asked, 0.2);
  ASSERT_EQ(steps.size(), 4U);
  for (const CountStep& step : steps) {
    // Elements that would be a fifth more are balanced by the other chord.
    EXPECT_EQ(std::ranges::minmax(step.counts).min, 16);
    EXPECT_EQ(std::ranges::minmax(step.counts).max, 24);
  }
}

TEST(ErrorCounts, StepsThatMissTheNumberOfElementsAreLeftOut) {
  ErrorParts of = one_block(0.5);
  of.is_fixed[0] = true;
  EXPECT_EQ(count_steps(of, as_asked, 0).size(), 2U);
  EXPECT_TRUE(count_steps(of, as_asked, 0.2).empty());
}

TEST(ErrorCounts, HopelessStepsAreLeftOut) {
  // One element less of the chord with nearly the whole error is estimated at 4 ln (1.75 * 114 / 120) = 2.04.
  const ErrorParts of{{0.98, 0.02}, {4, 30}, {false, false}, {{0, 1}}, 120};
  const std::vector<CountStep> steps = count_steps(of, as_asked, 0.25);
  ASSERT_FALSE(steps.empty());
  for (const CountStep& step : steps) EXPECT_EQ(step.counts, (std::vector<int>{5, 22}));
}

TEST(ErrorCounts, PrescribedCountsStay) {
  ErrorParts of = one_block(9.0 / 13);
  of.is_fixed[0] = true;
  for (const CountStep& step : count_steps(of, as_asked, 0)) EXPECT_EQ(step.counts[0], 20);
}

TEST(ErrorCounts, CountsAreThoseThatTheBoundaryAllows) {
  const AchievedCount even_first = [](int chord, int count) {
    return chord == 0 ? count + count % 2 : std::max(count, 20);
  };
  const std::vector<CountStep> steps = count_steps(one_block(9.0 / 13), even_first, 0);
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_EQ(steps[0].counts, (std::vector<int>{22, 20}));
  EXPECT_EQ(steps[1].counts, (std::vector<int>{20, 21}));
}

TEST(ErrorCounts, MirrorImagesGetTheSameCount) {
  const ErrorParts of{{0.5, 0.25, 0.25 * (1 + 1e-5)}, {20, 10, 10}, {true, false, false}, {{0, 1}, {2, 0}}, 400};
  const std::vector<CountStep> steps = count_steps(of, as_asked, 0);
  ASSERT_FALSE(steps.empty());
  for (const CountStep& step : steps) EXPECT_EQ(step.counts[1], step.counts[2]);
}

}  // namespace
}  // namespace quadrille::sizing
