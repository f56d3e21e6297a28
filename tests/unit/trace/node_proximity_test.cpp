#include "trace/node_proximity.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quadrille::trace {
namespace {

const PointGrid nodes({{0, 0}, {1, 0}});
constexpr double hit = 1e-3;

TEST(NodeProximity, StepsAreHalfTheDistanceToTheNearestOtherNode) {
  NodeProximity proximity(nodes, nodes.points()[0], true);
  EXPECT_EQ(proximity.move_to({0.2, 0}), 1);
  EXPECT_NEAR(proximity.longest_step(), 0.4, 1e-15);
}

TEST(NodeProximity, WithoutOtherNodesStepsAreNotBounded) {
  const PointGrid one({{0, 0}});
  NodeProximity proximity(one, one.points()[0], true);
  EXPECT_EQ(proximity.move_to({0.2, 0}), -1);
  EXPECT_TRUE(std::isinf(proximity.longest_step()));
}

TEST(NodeProximity, ALineHitsItsOwnNodeOnceItHasLeftIt) {
  NodeProximity proximity(nodes, nodes.points()[0], true);
  EXPECT_EQ(proximity.node_hit_at({0.5 * hit, 0}, hit), -1);
  EXPECT_EQ(proximity.node_hit_at({11 * hit, 0}, hit), -1);
  EXPECT_EQ(proximity.node_hit_at({0.5 * hit, 0}, hit), 0);
}

TEST(NodeProximity, AnotherNodeIsHitWithinTheDistance) {
  NodeProximity proximity(nodes, nodes.points()[0], true);
  EXPECT_EQ(proximity.node_hit_at({1 - 1.1 * hit, 0}, hit), -1);
  EXPECT_EQ(proximity.node_hit_at({1 - 0.9 * hit, 0}, hit), 1);
}

}  // namespace
}  // namespace quadrille::trace
