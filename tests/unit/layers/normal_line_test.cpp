#include "layers/normal_line.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../hand_made.hpp"

namespace quadrille::layers {
namespace {

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

}  // namespace
}  // namespace quadrille::layers
