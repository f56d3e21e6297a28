#include "layers/wall_line.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../hand_made.hpp"
#include "layers/normal_line.hpp"
#include "layers/side_table.hpp"
#include "spectral/quadrature.hpp"

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

TEST(WallLine, WalksPiecesBackwards) {
  const CadFace face = hand_made::l_shape().face;
  const std::vector<Nurbs> none;
  const curve::CurveTable table(face, none);
  const WallLine wall(table, {{3, 1, 0}, {2, 1, 0}});
  WallPoint foot{0, 1};
  EXPECT_NEAR(wall.distance({1.5, 0.7}, foot), 0.3, 1e-14);
  EXPECT_EQ(foot.piece, 1);
}

TEST(NormalLine, FindsHeightsAboveACircleAlongASlantedLine) {
  const CadFace face = hand_made::cut_annulus(1).face;  // curve 0: radius 1
  const std::vector<Nurbs> none;
  const curve::CurveTable table(face, none);
  const Nurbs& circle = face.curves[0];
  const WallLine wall(table, {{0, circle.begin(), circle.end()}});
  const NormalLine line = [](double u) { return Vec2{1 - 0.8 * u, 0.3 * u}; };
  const std::vector<double> heights = node_heights({1e-6, 1e-3, 0.1}, 4);
  EXPECT_EQ(heights.size(), 12u);
  EXPECT_EQ(heights[3], 1e-6);
  EXPECT_EQ(heights.back(), 0.1);
  const std::vector<double> u = parameters_at_heights(line, wall, {0, circle.begin()}, heights);
  ASSERT_EQ(u.size(), heights.size());
  for (std::size_t k = 0; k < u.size(); ++k) EXPECT_NEAR(1 - norm(line(u[k])), heights[k], 1e-10 * heights[k] + 1e-15);
}

TEST(NormalLine, EndsWhereTheLineTurnsBack) {
  const CadFace face = hand_made::unit_square().face;
  const std::vector<Nurbs> none;
  const curve::CurveTable table(face, none);
  const WallLine wall(table, {{0, 0, 1}});
  const NormalLine line = [](double u) { return Vec2{0.5 + 0.2 * u, 4 * u * (1 - u) * 0.3}; };
  EXPECT_EQ(parameters_at_heights(line, wall, {0, 0.5}, {0.1, 0.2, 0.29, 0.31, 0.4}).size(), 3u);
}

TEST(SideTable, IsTheChainToRoundOff) {
  const CadFace face = hand_made::elbow().face;  // curves 0 and 1: a line and a quarter circle
  const std::vector<Nurbs> none;
  const curve::CurveTable table(face, none);
  const curve::Chain chain(table, {{0, 0, 1}, {1, face.curves[1].begin(), face.curves[1].end()}});
  const SideTable forwards(chain, false), backwards(chain, true);
  for (int k = 0; k <= 1000; ++k) {
    const double f = k / 1000.0;
    EXPECT_LE(distance(forwards.at(f), chain.at(f).position), 1e-12 * chain.length());
    EXPECT_LE(distance(backwards.at(f), chain.at(1 - f).position), 1e-12 * chain.length());
  }
  EXPECT_EQ(forwards.at(0), chain.at(0).position);
  EXPECT_EQ(forwards.at(1), chain.at(1).position);
}

}  // namespace
}  // namespace quadrille::layers
