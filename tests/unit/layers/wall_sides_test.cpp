#include "layers/wall_sides.hpp"

#include <gtest/gtest.h>

#include "wall_samples.hpp"

namespace quadrille::layers {
namespace {

using wall_samples::PlannedWalls;

/// The wall side at which the arc from a to b starts at a; -1: none.
int wall_at(const PlannedWalls& p, Vec2 a, Vec2 b) {
  const int arc = p.arc_between(a, b);
  const bool is_from = distance(p.layout.nodes[p.layout.arcs[arc].from].position, a) < 1e-9;
  return p.plan.walls.at_arc_end[arc][is_from ? 0 : 1];
}

TEST(WallSides, MarkTheEndsOfArcsThatStartThere) {
  const PlannedWalls p(wall_samples::row({1, 1, 1}), 0.3, {"side_1:first=0.01,layers=2"});
  for (const double x : {1.0, 2.0}) {
    EXPECT_EQ(wall_at(p, {x, 0}, {x, 1}), 0);
    EXPECT_EQ(wall_at(p, {x, 1}, {x, 0}), -1);
  }
  for (const double x : {0.0, 3.0}) EXPECT_EQ(wall_at(p, {x, 0}, {x, 1}), -1);
  EXPECT_EQ(wall_at(p, {1, 0}, {2, 0}), -1) << "the wall itself";
}

TEST(WallSides, ThatContinueEachOtherMarkTheirCommonArcOnce) {
  const PlannedWalls p(wall_samples::row({1, 1}), 0.3, {"side_0,side_1:first=0.01,layers=2"});
  ASSERT_EQ(p.plan.walls.sides.size(), 2u);
  EXPECT_EQ(wall_at(p, {1, 0}, {1, 1}), 0) << "the first side";
  EXPECT_EQ(wall_at(p, {2, 0}, {2, 1}), 1);
  EXPECT_TRUE(p.plan.walls.overruled.empty()) << "one spec for both";
}

TEST(WallSides, BendTowardsTheirBlocksOnTheInsideOfACircle) {
  const PlannedWalls p(wall_samples::annulus_of_half_circles(), 0.3, {"side_0,side_1,side_2:first=0.01,layers=2"});
  int inside = 0;
  for (const WallSide& wall : p.plan.walls.sides) {
    const bool is_inside = wall.line.pieces()[wall.begin.piece].curve == 0;
    EXPECT_NEAR(greatest_bend(p.measured.curves(), wall), is_inside ? 1 : 0, 1e-9);
    inside += is_inside;
  }
  EXPECT_EQ(inside, 2);
}

TEST(WallSides, PointsOfASideThatIsWalkedAgainstItsArc) {
  const WallSide wall{0, 0, 0, {}, {2, 0.0}, {4, 1.0}, false};  // pieces 2 to 4 of the line
  curve::ChainPoint on_arc;
  on_arc.piece = 1, on_arc.t = 0.3;
  EXPECT_EQ(wall_point(wall, on_arc, false).piece, 3);
  EXPECT_EQ(wall_point(wall, on_arc, true).piece, 3);
  on_arc.piece = 0;
  EXPECT_EQ(wall_point(wall, on_arc, false).piece, 2);
  EXPECT_EQ(wall_point(wall, on_arc, true).piece, 4);
  EXPECT_EQ(wall_point(wall, on_arc, true).t, 0.3);
}

}  // namespace
}  // namespace quadrille::layers
