#include "field/hole_points.hpp"

#include <gtest/gtest.h>

#include "../triangulate/faces.hpp"

namespace quadrille::field {
namespace {

using namespace testing_faces;

const Loop outline = polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}});

TEST(HolePoints, AreTheCentresOfRoundAndConvexHoles) {
  const CadFace face =
      make_face({outline, hole({1, 1}, 0.3), polygon({{2.5, 2.5}, {2.5, 3.5}, {3.5, 3.5}, {3.5, 2.5}})});
  const std::vector<Vec2> points = hole_points(face);
  ASSERT_EQ(points.size(), 2u);
  EXPECT_NEAR(distance(points[0], {1, 1}), 0, 1e-12);
  EXPECT_NEAR(distance(points[1], {3, 3}), 0, 1e-12);
}

TEST(HolePoints, LieInsideThinAngles) {
  // An L of arms 2 long and w wide: its centroid is outside.
  for (const double w : {0.3, 1e-2, 1e-4}) {
    const CadFace face =
        make_face({outline, polygon({{1, 1}, {1, 3}, {1 + w, 3}, {1 + w, 1 + w}, {3, 1 + w}, {3, 1}})});
    const Vec2 x = hole_points(face).at(0);
    const bool in_upright = x.x > 1 && x.x < 1 + w && x.y > 1 && x.y < 3;
    const bool in_foot = x.y > 1 && x.y < 1 + w && x.x > 1 && x.x < 3;
    EXPECT_TRUE(in_upright || in_foot) << x.x << " " << x.y;
    EXPECT_GT(std::min(std::min(x.x, x.y) - 1, 10.0), 0.2 * w);  // with room on both sides
  }
}

TEST(HolePoints, MoveWithTheFace) {
  const CadFace face = make_face({outline, polygon({{1, 1}, {1.2, 2}, {3, 2.5}, {2, 1}})});
  const Vec2 d = 2.5 * unit(0.6), shift{10, -3}, x = hole_points(face).at(0);
  const Vec2 there = hole_points(moved(face, 2.5, 0.6, shift)).at(0);
  EXPECT_NEAR(distance(there, Vec2{d.x * x.x - d.y * x.y, d.y * x.x + d.x * x.y} + shift), 0, 1e-12);
}

}  // namespace
}  // namespace quadrille::field
