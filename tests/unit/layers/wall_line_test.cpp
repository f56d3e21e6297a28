#include "layers/wall_line.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../hand_made.hpp"

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

}  // namespace
}  // namespace quadrille::layers
