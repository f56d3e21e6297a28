#include "sizing/grading.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace quadrille::sizing {
namespace {

TEST(Grading, WithoutLengthsIsTheIdentity) {
  const Grading equal(7.5);
  EXPECT_TRUE(equal.is_identity());
  EXPECT_EQ(equal.count(), 7.5);
  EXPECT_EQ(equal.parameter(0.3), 0.3);
  EXPECT_TRUE(Grading({0, 0.5, 1}, {0.1, 0.1, 0.1}).is_identity());
  EXPECT_NEAR(Grading({0, 0.5, 1}, {0.1, 0.1, 0.1}).count(), 10, 1e-13);
}

TEST(Grading, LengthsThatGrowLinearlyGiveAGeometricSeries) {
  // eta = 0.01 + s u: the ends are at u = 0.01 (exp(s n) - 1) / s, neighbours differ by exp(s).
  const double s = 0.2;
  const Grading grading({0, 1}, {0.01, 0.01 + s});
  EXPECT_NEAR(grading.count(), std::log(1 + s / 0.01) / s, 1e-12);
  for (const double n : {1.0, 2.0, 7.3})
    EXPECT_NEAR(grading.parameter(n / grading.count()), 0.01 * (std::exp(s * n) - 1) / s, 1e-14);
}

TEST(Grading, ShareAndParameterAreInverse) {
  const Grading grading({0, 0.1, 0.4, 0.8, 1}, {0.3, 0.01, 0.02, 0.02, 0.5});
  double before = -1;
  for (int k = 0; k <= 200; ++k) {
    const double v = k / 200.0, u = grading.parameter(v);
    EXPECT_GT(u, before);
    EXPECT_NEAR(grading.cumulative(u), v, 1e-13);
    before = u;
  }
  EXPECT_EQ(grading.parameter(0), 0);
  EXPECT_EQ(grading.parameter(1), 1);
  EXPECT_EQ(grading.cumulative(1), 1);
}

TEST(Grading, MirroredLengthsGiveMirroredEnds) {
  const Grading grading({0, 0.1, 0.4, 1}, {0.3, 0.01, 0.02, 0.5}), mirrored({0, 0.6, 0.9, 1}, {0.5, 0.02, 0.01, 0.3});
  for (int k = 0; k <= 20; ++k) EXPECT_NEAR(grading.parameter(k / 20.0), 1 - mirrored.parameter(1 - k / 20.0), 1e-14);
}

TEST(Grading, LimitedLengthsFallOnlyAndKeepTheSlope) {
  const std::vector<double> u{0, 0.2, 0.5, 0.6, 1}, eta{1, 0.1, 1, 0.05, 0.06};
  const std::vector<double> result = limited(u, eta, 0.5);
  const std::vector<double> expected{0.2, 0.1, 0.1, 0.05, 0.06};
  for (std::size_t k = 0; k < u.size(); ++k) EXPECT_NEAR(result[k], expected[k], 1e-15) << k;
}

TEST(Grading, RefinedElementsMeetTheConstraintsAndShrinkEveryTime) {
  const Grading grading({0, 1}, {0.05, 0.25});
  const double count = std::ceil(grading.count());
  const Grading once = refine_grading(grading, count, {{0.8, 0.9, 0.02, 1.5}}, 0.2);
  EXPECT_GT(once.count(), count);
  const auto length_at = [](const Grading& g, double u) {
    return 1e-6 / (g.cumulative(u + 1e-6) - g.cumulative(u)) / g.count();
  };
  for (const double u : {0.81, 0.85, 0.89}) EXPECT_NEAR(length_at(once, u), 0.02, 1e-5);
  EXPECT_NEAR(length_at(once, 0.75), 0.03, 1e-3);
  EXPECT_NEAR(length_at(once, 0.1), length_at(grading, 0.1) * grading.count() / count, 1e-5);
  // A constraint that is longer than the present elements still shortens them.
  const Grading twice = refine_grading(once, once.count(), {{0.8, 0.9, 0.5, 1.5}}, 0.2);
  EXPECT_NEAR(length_at(twice, 0.85), 0.02 / 1.5, 1e-5);
}

using Counts = std::vector<int>;

TEST(Spacing, OneSegmentIsCutEvenly) {
  const Segments whole;
  EXPECT_EQ(segment_counts(whole, 4, false), Counts{4});
  EXPECT_EQ(interval_ends(whole, {4}), (std::vector<double>{0, 0.25, 0.5, 0.75, 1}));
}

TEST(Spacing, CountsFollowTheLengths) {
  const Segments segments{{0, 0.6, 1}, {1, 1}};
  EXPECT_EQ(segment_counts(segments, 5, false), (Counts{3, 2}));
  EXPECT_EQ(segment_counts(segments, 10, false), (Counts{6, 4}));
}

TEST(Spacing, LeastCountsAreKept) {
  const Segments segments{{0, 0.01, 1}, {3, 1}};
  EXPECT_EQ(segments.least_count(), 4);
  EXPECT_EQ(segment_counts(segments, 4, false), (Counts{3, 1}));
  EXPECT_EQ(segment_counts(segments, 20, false), (Counts{3, 17}));
}

TEST(Spacing, EqualSegmentsGetEqualCountsOrNone) {
  const Segments halves{{0, 0.5, 1}, {1, 1}};
  EXPECT_EQ(segment_counts(halves, 6, false), (Counts{3, 3}));
  EXPECT_EQ(segment_counts(halves, 7, false), Counts{});
  EXPECT_EQ(segment_counts(halves, 7, true), (Counts{4, 3}));
}

TEST(Spacing, MirrorImageIsCutInMirroredPlaces) {
  const Segments segments{{0, 0.2, 0.55, 1}, {1, 2, 1}}, mirrored{{0, 0.45, 0.8, 1}, {1, 2, 1}};
  for (int count = 4; count < 40; ++count) {
    Counts counts = segment_counts(segments, count, false);
    Counts other = segment_counts(mirrored, count, false);
    std::reverse(other.begin(), other.end());
    EXPECT_EQ(counts, other) << count;
  }
}

}  // namespace
}  // namespace quadrille::sizing
