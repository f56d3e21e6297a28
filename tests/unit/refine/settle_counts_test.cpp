#include "refine/settle_counts.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "chord_samples.hpp"

namespace quadrille::refine {
namespace {

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
