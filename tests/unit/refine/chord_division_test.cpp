#include "refine/chord_division.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "chord_samples.hpp"

namespace quadrille::refine {
namespace {

TEST(Anchors, FacingBreaksShareOne) {
  const std::vector<Anchor> anchors = find_anchors({{0.52, 0.5, 1}, {0.2, 0.2, 0}, {0.5, 0.5, 0}}, 0.05);
  ASSERT_EQ(anchors.size(), 2u);
  EXPECT_EQ(anchors[0].u, 0.2);
  EXPECT_NEAR(anchors[1].u, 0.51, 1e-15);
  EXPECT_EQ(anchors[1].breaks.size(), 2u);
}

TEST(Anchors, BreaksOutOfReachStandAlone) { EXPECT_EQ(find_anchors({{0.2, 0.2, 0}, {0.3, 0.3, 1}}, 0.05).size(), 2u); }

TEST(Anchors, BreaksOfOneArcAreNeverJoined) {
  // A fillet on each of two facing arcs, both ends within reach of each other: end joins end.
  const std::vector<Anchor> anchors =
      find_anchors({{0.500, 0.5, 0}, {0.510, 0.51, 0}, {0.501, 0.5, 1}, {0.511, 0.51, 1}}, 0.1);
  ASSERT_EQ(anchors.size(), 2u);
  for (const Anchor& a : anchors) {
    ASSERT_EQ(a.breaks.size(), 2u);
    EXPECT_NE(a.breaks[0].arc, a.breaks[1].arc);
  }
  EXPECT_LT(anchors[0].u, anchors[1].u);
}

TEST(Anchors, NoneWithoutBreaks) { EXPECT_TRUE(find_anchors({}, 0.1).empty()); }

/// Anchors at 0.2, 0.5 and 0.6; the one in the middle is of two arcs.
AnchoredSegments three_anchors() {
  return {{{0.2, {{0.2, 0.25, 0}}}, {0.5, {{0.45, 0.4, 0}, {0.55, 0.6, 1}}}, {0.6, {{0.6, 0.7, 0}}}}, {}, {}};
}

TEST(AnchoredSegments, RequiredAnchorsAreTheInnerEndsInOrder) {
  AnchoredSegments anchored = three_anchors();
  for (const int anchor : {2, 0, 1, 0}) require_anchor(anchored, anchor);
  EXPECT_EQ(anchored.required, (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(anchored.segments.ends, (std::vector<double>{0, 0.2, 0.5, 0.6, 1}));
  EXPECT_EQ(anchored.segments.least_counts, (std::vector<int>{1, 1, 1, 1}));
}

TEST(AnchoredSegments, OnlyTheSegmentThatIsCutForgetsItsCount) {
  AnchoredSegments anchored = three_anchors();
  require_anchor(anchored, 1);
  anchored.segments.least_counts = {4, 7};
  require_anchor(anchored, 1);
  EXPECT_EQ(anchored.segments.least_counts, (std::vector<int>{4, 7})) << "it is required already";
  require_anchor(anchored, 0);
  EXPECT_EQ(anchored.segments.least_counts, (std::vector<int>{1, 1, 7}));
}

TEST(AnchoredSegments, MovedBreaksMoveAnchorsAndEnds) {
  AnchoredSegments anchored = three_anchors();
  require_anchor(anchored, 1);
  move_breaks(anchored, [](const Break& b) { return b.fraction; });
  EXPECT_EQ(anchored.anchors[0].u, 0.25);
  EXPECT_EQ(anchored.anchors[1].breaks[0].u, 0.4);
  EXPECT_NEAR(anchored.anchors[1].u, 0.5, 1e-15) << "the mean of its breaks";
  EXPECT_EQ(anchored.segments.ends[1], anchored.anchors[1].u);
}

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

/// The long sides of the elbow: a line of length 1, then an arc of radius 2 or 1.
constexpr int long_side = 0;

TEST(SettleCounts, TakesThePlannedCountWhereNothingStandsAgainstIt) {
  const ChordSample sample(hand_made::unit_square(), 0, 7, {4, 1});
  ChordDivision division = begin_division(sample.task);
  EXPECT_EQ(division.least_count, 7);
  EXPECT_TRUE(division.anchored.anchors.empty());
  settle_counts(sample.task, division);
  EXPECT_EQ(division.count(), 7);
  for (const sizing::ArcDivision& arc : division.arcs) EXPECT_EQ(arc.num_intervals(), 7);
}

TEST(SettleCounts, BreaksAreAnchorsAndRequiredOnlyWhereAGivenNameEnds) {
  SeparatrixGraph graph = hand_made::elbow();
  const ChordSample plain(graph, long_side, 4, {4, 1});
  const ChordDivision division = begin_division(plain.task);
  EXPECT_FALSE(division.anchored.anchors.empty());
  EXPECT_TRUE(division.anchored.required.empty());
  hand_made::give_name(graph.face, 1, "bend");
  const ChordSample named(graph, long_side, 4, {4, 1});
  EXPECT_EQ(begin_division(named.task).anchored.required.size(), 1u);
}

TEST(SettleCounts, ClosedArcsGetThreeElementsAndParallelOnesTwo) {
  for (const auto& [cuts, count] : {std::pair{1, 3}, {2, 2}, {3, 1}}) {
    const ChordSample ring(hand_made::cut_annulus(cuts), 0, 1, {4, 1});
    EXPECT_EQ(begin_division(ring.task).least_count, count) << cuts;
  }
}

TEST(SettleCounts, ACountRisesUntilEqualSegmentsGetEqualCounts) {
  ChordSample sample(hand_made::unit_square(), 0, 3, {4, 1});
  ChordDivision division = begin_division(sample.task);
  division.anchored.anchors = {{0.5, {}}};
  require_anchor(division.anchored, 0);
  settle_counts(sample.task, division);
  EXPECT_EQ(division.counts, (std::vector<int>{2, 2})) << "three elements cannot be divided symmetrically";
  sample.plan.is_prescribed = true;
  settle_counts(sample.task, division);
  EXPECT_EQ(division.counts, (std::vector<int>{2, 1})) << "a prescribed count stays";
  sample.plan.is_by_user = false;
  settle_counts(sample.task, division);
  EXPECT_EQ(division.counts, (std::vector<int>{2, 2})) << "one that was found rises";
}

TEST(SettleCounts, ACountRisesUntilNoIntervalIsLongerThanPlannedByAQuarter) {
  ChordSample sample(hand_made::unit_square(), 0, 2, {4, 1});
  ChordDivision division = begin_division(sample.task);
  division.anchored.anchors = {{0.2, {}}};
  require_anchor(division.anchored, 0);
  settle_counts(sample.task, division);
  EXPECT_EQ(division.counts, (std::vector<int>{1, 2})) << "0.8 is longer than 1.25 / 2";
  sample.plan.is_prescribed = true;
  settle_counts(sample.task, division);
  EXPECT_EQ(division.counts, (std::vector<int>{1, 1}));
}

TEST(SettleCounts, TooManyElementsAreAnErrorWithAPlace) {
  const ChordSample sample(hand_made::unit_square(), 0, max_intervals + 1, {4, 1});
  try {
    begin_division(sample.task);
    FAIL();
  } catch (const ComputeError& error) {
    EXPECT_NE(std::string(error.what()).find("(0.5, 0)"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace quadrille::refine
