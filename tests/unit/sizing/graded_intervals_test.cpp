#include "sizing/graded_intervals.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace quadrille::sizing {
namespace {

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

TEST(GradedIntervals, AreEqualBetweenFreeEnds) {
  EXPECT_EQ(graded_intervals({}, 4, 2, 1), (std::vector<double>{0.5, 0.5, 0.5, 0.5}));
}

TEST(GradedIntervals, GrowFromTheirNeighbourAndFillTheLength) {
  const std::vector<double> grown = graded_intervals({0.01, 0}, 20, 2, 0.2);
  EXPECT_NEAR(sum(grown), 2, 1e-12);
  EXPECT_TRUE(std::is_sorted(grown.begin(), grown.end()));
  EXPECT_LE(grown.back(), 0.2);
}

TEST(GradedIntervals, AreMirroredWithTheirEnds) {
  std::vector<double> there = graded_intervals({0.01, 0.05}, 15, 1, 0.2);
  const std::vector<double> back = graded_intervals({0.05, 0.01}, 15, 1, 0.2);
  std::reverse(there.begin(), there.end());
  for (std::size_t k = 0; k < back.size(); ++k) EXPECT_NEAR(there[k], back[k], 1e-13);
}

TEST(GradedIntervals, OfTheNeighboursLengthStayAsTheyAre) {
  for (const double interval : graded_intervals({0.1, 0.1}, 10, 1, 5)) EXPECT_NEAR(interval, 0.1, 1e-12);
}

TEST(GradedIntervals, ShrinkWhereThereIsLittleRoom) {
  const std::vector<double> crowded = graded_intervals({0.1, 0}, 10, 0.5, 1);
  EXPECT_NEAR(sum(crowded), 0.5, 1e-12);
  EXPECT_TRUE(std::is_sorted(crowded.rbegin(), crowded.rend()));
}

TEST(GradedIntervals, LeastCountKeepsGrowthAndSizeAndOneLessDoesNot) {
  for (const GradedEnds ends : {GradedEnds{1e-3, 0}, GradedEnds{0, 1e-3}, GradedEnds{1e-3, 4e-3}}) {
    const int count = least_graded_count(ends, 1, 0.1, 1.2, 1000);
    const auto intervals = graded_intervals(ends, count, 1, 0.1), fewer = graded_intervals(ends, count - 1, 1, 0.1);
    EXPECT_LE(worst_growth(ends, intervals), 1.2 * (1 + 2e-6));
    EXPECT_LE(*std::max_element(intervals.begin(), intervals.end()), 0.1 * (1 + 1e-6));
    EXPECT_TRUE(worst_growth(ends, fewer) > 1.2 || *std::max_element(fewer.begin(), fewer.end()) > 0.1);
  }
  EXPECT_EQ(least_graded_count({}, 1, 0.3, 1.2, 1000), 4);
}

TEST(GradedIntervals, WorstGrowthCountsTheNeighbours) {
  EXPECT_DOUBLE_EQ(worst_growth({1, 0}, {2, 2}), 2);
  EXPECT_DOUBLE_EQ(worst_growth({0, 8}, {2, 2}), 4);
  EXPECT_DOUBLE_EQ(worst_growth({}, {2, 2}), 1);
}

}  // namespace
}  // namespace quadrille::sizing
