#include "guide/index_sum.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace quadrille::guide {
namespace {

/// One node of valence 3, one corner of valence 1, a boundary node of valence 3 and a cluster of index -2.
CriticalPoints some_points() {
  CriticalPoints points;
  points.critical_points.resize(1);
  points.critical_points[0].valence = 3;
  points.corners = {{0, {0, 0}, 90, 1, {1, 0}}};
  points.boundary_nodes.resize(1);
  points.clusters = {{{1, 1}, 0, -2, {{1, 1}}, {}}};
  return points;
}

TEST(IndexSumWithClusters, AddsNodesCornersBoundaryNodesAndClusters) {
  EXPECT_EQ(index_sum_with_clusters(some_points()), 1 + 1 - 1 - 2);
  EXPECT_EQ(index_sum_of(some_points()), 1 + 1 - 1);
}

TEST(RequireIndexSum, AcceptsTheExpectedSum) {
  CriticalPoints points = some_points();
  points.index_sum = points.index_sum_expected = 1;
  EXPECT_NO_THROW(require_index_sum(points));
  points.index_sum_expected = 2;
  EXPECT_THROW(require_index_sum(points), ComputeError) << "any other one is refused";
}

TEST(RequireIndexSum, ReportsTheDifferenceAndTheCornerNearestToATie) {
  CriticalPoints points;
  points.origin = {100, 0};
  points.corners = {{0, {0, 0}, 90, 1, {1, 0}}, {1, {1, 2}, 134, 1, {0, 1}}};
  points.index_sum = 2;
  points.index_sum_expected = 4;
  try {
    require_index_sum(points);
    FAIL();
  } catch (const ComputeError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("2 too few"), std::string::npos) << message;
    EXPECT_NE(message.find("134 degrees at (101, 2), valence 1"), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace quadrille::guide
