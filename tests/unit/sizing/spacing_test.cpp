#include "sizing/spacing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace quadrille::sizing {
namespace {

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
