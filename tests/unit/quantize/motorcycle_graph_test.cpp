#include "quantize/motorcycle_graph.hpp"

#include <gtest/gtest.h>

namespace quadrille::quantize {
namespace {

constexpr double tie = 1e-6;

graph::Crossing at(int a, double s, int b, double t) { return {a, b, s, t, {}, 1.5}; }

TEST(MotorcycleGraph, TheLaterOneStopsAndTheEarlierGoesOn) {
  const auto covered = trace_motorcycle_graph({{10}, {10}}, {at(0, 3, 1, 2)}, tie);
  EXPECT_FALSE(covered[0].is_whole());
  EXPECT_EQ(covered[0].first, 3);
  EXPECT_TRUE(covered[1].is_whole());
}

TEST(MotorcycleGraph, AStoppedLineStopsNobodyBehindItsEnd) {
  // Line 1 would cut line 2, but has been stopped by line 0 before.
  const auto covered = trace_motorcycle_graph({{10}, {10}, {10}}, {at(0, 1, 1, 2), at(1, 3, 2, 4)}, tie);
  EXPECT_EQ(covered[1].first, 2);
  EXPECT_TRUE(covered[2].is_whole());
}

TEST(MotorcycleGraph, ALineStopsAtItsOwnTrail) {
  const auto covered = trace_motorcycle_graph({{100}}, {at(0, 5, 0, 30)}, tie);
  EXPECT_EQ(covered[0].first, 30);
}

TEST(MotorcycleGraph, ATieLetsBothPassButOnlyOnce) {
  const auto covered = trace_motorcycle_graph({{10}, {10}}, {at(0, 3, 1, 3 + 1e-9), at(0, 5, 1, 5)}, tie);
  EXPECT_EQ(covered[0].is_whole() + covered[1].is_whole(), 1);
  EXPECT_EQ(std::min(covered[0].first, covered[1].first), 5);
}

TEST(MotorcycleGraph, TheTwoFrontsOfAMergedLineMeet) {
  const auto covered = trace_motorcycle_graph({{10, true}, {20}}, {at(0, 4, 1, 15)}, tie);
  EXPECT_TRUE(covered[0].is_whole());
  EXPECT_EQ(covered[1].first, 15);
}

TEST(MotorcycleGraph, AMergedLineIsCutWhereBothFrontsAreStopped) {
  const auto covered = trace_motorcycle_graph({{10, true}, {20}, {20}}, {at(0, 3, 1, 1), at(0, 8, 2, 1)}, tie);
  EXPECT_FALSE(covered[0].is_whole());
  EXPECT_EQ(covered[0].first, 3);
  EXPECT_EQ(covered[0].last, 8);
}

TEST(MotorcycleGraph, FrontsOfAMergedLineThatComeToOneCrossingFromBothSidesPassIt) {
  // Line 1 was there first; the front from 0 stops at it, the one from the end comes to the same place.
  const auto covered = trace_motorcycle_graph({{10, true}, {20}}, {at(0, 4, 1, 1)}, tie);
  EXPECT_TRUE(covered[0].is_whole());
  EXPECT_TRUE(covered[1].is_whole());
}

TEST(MotorcycleGraph, ACutIsThereBeforeTheOthers) {
  const auto covered = trace_motorcycle_graph({{10}, {10, false, 100}}, {at(0, 1, 1, 9)}, tie);
  EXPECT_EQ(covered[0].first, 1);
  EXPECT_TRUE(covered[1].is_whole());
}

}  // namespace
}  // namespace quadrille::quantize
