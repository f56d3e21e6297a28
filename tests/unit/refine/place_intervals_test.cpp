#include "refine/place_intervals.hpp"

#include <gtest/gtest.h>

#include "chord_samples.hpp"
#include "refine/settle_counts.hpp"

namespace quadrille::refine {
namespace {

TEST(PlaceIntervals, EqualElementsOnAllArcs) {
  const ChordSample sample(hand_made::unit_square(), 0, 4, {4, 1});
  ChordDivision division = begin_division(sample.task);
  division.counts = {4};
  for (const int i : {0, 1}) {
    const PlacedIntervals placed = place_intervals(sample.task, division, i);
    EXPECT_EQ(placed.division.ends, (std::vector<double>{0, 0.25, 0.5, 0.75, 1}));
    EXPECT_NEAR(placed.longest, 1, 1e-12);
  }
}

TEST(PlaceIntervals, ElementsFollowTheGradingAlongTheChordAlsoOnArcsAgainstIt) {
  ChordSample sample(hand_made::unit_square(), 0, 2, {4, 1});
  sample.plan.grading = sizing::Grading({0, 1}, {0.1, 0.9});
  ChordDivision division = begin_division(sample.task);
  division.counts = {2};
  const double middle = sample.plan.grading.parameter(0.5);
  ASSERT_LT(middle, 0.4);
  EXPECT_EQ(place_intervals(sample.task, division, 0).division.ends[1], middle);
  EXPECT_EQ(place_intervals(sample.task, division, 1).division.ends[1], 1 - middle);
}

TEST(PlaceIntervals, AnArcMeetsItsOwnBreaksToTheLastDigit) {
  const ChordSample sample(hand_made::elbow(), 0, 4, {4, 1});
  ChordDivision division = begin_division(sample.task);
  require_anchor(division.anchored, 0);
  division.counts.assign(division.anchored.segments.least_counts.size(), 2);
  const std::vector<Break>& breaks = division.anchored.anchors[0].breaks;
  ASSERT_FALSE(breaks.empty());
  for (const Break& b : breaks) EXPECT_EQ(place_intervals(sample.task, division, b.arc).division.ends[2], b.fraction);
}

TEST(PlaceIntervals, LengthsAreMeasuredAgainstThePlanOnTheLongestArc) {
  const ChordSample sample(hand_made::quarter_annulus(), 1, 10, {4, 1});
  ChordDivision division = begin_division(sample.task);
  division.counts = {5};
  EXPECT_NEAR(place_intervals(sample.task, division, 0).longest, 2, 1e-9) << "half as many as planned";
  EXPECT_NEAR(place_intervals(sample.task, division, 1).longest, 1, 1e-9) << "an arc of half the length";
}

}  // namespace
}  // namespace quadrille::refine
