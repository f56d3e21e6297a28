#include "layers/wall_sides.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../chart_samples.hpp"
#include "../hand_made.hpp"
#include "wall_samples.hpp"

namespace quadrille::layers {
namespace {

TEST(WallLine, TellsDistancesAcrossJoints) {
  const CadFace face = hand_made::l_shape().face;  // (0,0) (2,0) (2,1) (1,1) (1,2) (0,2)
  const std::vector<Nurbs> none;
  const curve::CurveTable table(face, none);
  const WallLine wall(table, {{2, 0, 1}, {3, 0, 1}});  // (2,1) to (1,1) to (1,2)
  WallPoint foot{0, 0.1};
  EXPECT_NEAR(wall.distance({1.5, 0.7}, foot), 0.3, 1e-14);
  EXPECT_NEAR(wall.distance({0.7, 0.6}, foot), 0.5, 1e-14);  // of the reflex corner
  EXPECT_NEAR(wall.distance({0.8, 1.7}, foot), 0.2, 1e-14);
  EXPECT_EQ(foot.piece, 1);
  EXPECT_NEAR(foot.t, 0.7, 1e-12);
  EXPECT_NEAR(wall.distance({0.7, 2.4}, foot), 0.5, 1e-14);  // of its end
}

TEST(WallLine, InAConvexCornerTheNearerWallCounts) {
  const CadFace face = hand_made::unit_square().face;
  const std::vector<Nurbs> none;
  const curve::CurveTable table(face, none);
  const WallLine wall(table, {{0, 0, 1}, {1, 0, 1}});  // (0,0) to (1,0) to (1,1)
  WallPoint foot{0, 0.9};
  EXPECT_NEAR(wall.distance({0.9, 0.02}, foot), 0.02, 1e-14);
  EXPECT_NEAR(wall.distance({0.9, 0.3}, foot), 0.1, 1e-14);
  EXPECT_EQ(foot.piece, 1);
  EXPECT_NEAR(wall.distance({0.8, 0.1}, foot), 0.1, 1e-14);
}

TEST(WallLine, ContinuesStraightBeyondAnExtendedEnd) {
  const CadFace face = hand_made::unit_square().face;
  const std::vector<Nurbs> none;
  const curve::CurveTable table(face, none);
  for (const int step : {-1, 1}) {
    WallLine wall(table, {{0, 0, 1}});  // (0,0) to (1,0)
    wall.extend(step);
    WallPoint begin{0, 0.1}, end{0, 0.9};
    EXPECT_NEAR(wall.distance({-0.3, 0.4}, begin), step < 0 ? 0.4 : 0.5, 1e-14);
    EXPECT_NEAR(wall.distance({1.3, 0.4}, end), step < 0 ? 0.5 : 0.4, 1e-14);
  }
}

TEST(WallLine, WalksPiecesBackwards) {
  const CadFace face = hand_made::l_shape().face;
  const std::vector<Nurbs> none;
  const curve::CurveTable table(face, none);
  const WallLine wall(table, {{3, 1, 0}, {2, 1, 0}});
  WallPoint foot{0, 1};
  EXPECT_NEAR(wall.distance({1.5, 0.7}, foot), 0.3, 1e-14);
  EXPECT_EQ(foot.piece, 1);
}

using wall_samples::PlannedWalls;

/// The wall side at which the arc from a to b starts at a; -1: none.
int wall_at(const PlannedWalls& p, Vec2 a, Vec2 b) {
  const int arc = p.arc_between(a, b);
  const bool is_from = distance(p.layout.nodes[p.layout.arcs[arc].from].position, a) < 1e-9;
  return p.plan.walls.at_arc_end[arc][is_from ? 0 : 1];
}

TEST(WallLine, OnASurfaceDistancesAreLengthsInSpace) {
  // From the meridian y = 0 of the unit sphere, in stereographic projection, along a straight line of the chart: its
  // length is the integral of 2 / (1 + r^2).
  const CadFace face = samples::sphere_face(2, 10);
  const std::vector<Nurbs> none;
  const curve::CurveTable table(face, none);
  const Nurbs& side = face.curves[0];
  const WallLine wall(table, {{0, side.begin(), side.end()}}, sizing::chart_scale(face));
  WallPoint foot{0, side.begin()};
  for (const double x : {0.0, 0.2, 0.45}) {
    const double a = std::sqrt(1 + x * x), y = 0.1;
    EXPECT_NEAR(wall.distance({x, y}, foot), 2 / a * std::atan(y / a), 1e-7) << x;
  }
  EXPECT_NEAR(wall.scale_at({0.3, 0}), 2 / 1.09, 1e-7);
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
