#include "sizing/error_counts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace quadrille::sizing {
namespace {

int as_asked(int, int count) { return count; }

/// One block of 10 x 10 elements.
ErrorParts one_block(double first_part) {
  return {{first_part, 1 - first_part}, {10, 10}, {false, false}, {{0, 1}}, 100};
}

TEST(ErrorCounts, EqualPartsOfABlockKeepTheirCounts) {
  const ErrorCounts least = least_error_counts(one_block(0.5), as_asked);
  EXPECT_EQ(least.counts, (std::vector<int>{10, 10}));
  EXPECT_DOUBLE_EQ(least.ratio, 1);
}

TEST(ErrorCounts, TheChordWithTheGreaterPartGetsMoreElements) {
  // s1 (10 / n1)^2 + s2 (10 / n2)^2 at n1 n2 = 100 is least at n1 / n2 = sqrt(s1 / s2) = 3/2.
  const ErrorCounts least = least_error_counts(one_block(9.0 / 13), as_asked);
  EXPECT_EQ(least.counts, (std::vector<int>{12, 8}));
  const double sum = 9.0 / 13 / (1.2 * 1.2) + 4.0 / 13 / (0.8 * 0.8);
  EXPECT_NEAR(least.ratio, std::pow(sum * 96 / 100, 4), 1e-12);
}

TEST(ErrorCounts, PrescribedCountsStay) {
  ErrorParts of = one_block(9.0 / 13);
  of.is_fixed[0] = true;
  EXPECT_EQ(least_error_counts(of, as_asked).counts, (std::vector<int>{10, 10}));
}

TEST(ErrorCounts, CountsThatTheBoundaryRaisesAreCompared) {
  const AchievedCount even_first = [](int chord, int count) {
    return chord == 0 ? count + count % 2 : std::max(count, 9);
  };
  const ErrorCounts least = least_error_counts(one_block(9.0 / 13), even_first);
  EXPECT_EQ(least.counts[0] % 2, 0);
  EXPECT_GE(least.counts[1], 9);
}

TEST(ErrorCounts, NoCountLeavesTheRangeOfTheEstimate) {
  ErrorParts of = one_block(0.999);
  of.greatest_factor = 1;
  const ErrorCounts least = least_error_counts(of, as_asked);
  EXPECT_EQ(least.counts, (std::vector<int>{11, 9}));
}

TEST(ErrorCounts, MirrorImagesGetTheSameCount) {
  // Chord 0 crosses 1 and 2, which are equal but for 1e-5: 11 x (5 + 5) would be 11 x (5 + 6) if each counted
  // alone.
  const ErrorParts of{{0.5, 0.25, 0.25 * (1 + 1e-5)}, {10, 5, 5}, {true, false, false}, {{0, 1}, {2, 0}}, 107};
  const ErrorCounts least = least_error_counts(of, as_asked);
  EXPECT_EQ(least.counts[1], least.counts[2]);
}

}  // namespace
}  // namespace quadrille::sizing
