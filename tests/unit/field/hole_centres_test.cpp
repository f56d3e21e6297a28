#include "field/hole_centres.hpp"

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

using namespace testing_faces;

const Loop outline = polygon({{-9, -9}, {9, -9}, {9, 9}, {-9, 9}});

CadFace with_ellipse(double a, double b) {
  Loop loop = hole({0, 0}, 1);
  for (Vec2& pole : loop[0].poles) pole = {a * pole.x, b * pole.y};
  return make_face({outline, loop});
}

TEST(HoleFoci, AreNoneForCirclesAndPolygons) {
  EXPECT_TRUE(hole_foci(make_face({outline, hole({1, 1}, 0.3)})).empty());
  EXPECT_TRUE(hole_foci(make_face({outline, polygon({{0, 0}, {0, 1}, {5, 0}})})).empty());
}

TEST(HoleFoci, OfAThinEllipseAreItsFociWithTwoTurnsEach) {
  for (const double b : {1.0, 0.3, 0.03}) {
    const std::vector<HoleFocus> foci = hole_foci(with_ellipse(4, b));
    ASSERT_EQ(foci.size(), 2u) << b;
    for (const HoleFocus& focus : foci) {
      EXPECT_EQ(focus.turns, 2);
      EXPECT_NEAR(std::abs(focus.position.x), std::sqrt(16 - b * b), 0.1 * b * b);
      EXPECT_NEAR(focus.position.y, 0, 1e-6);
    }
  }
}

TEST(HoleFoci, OfASlotAreInsideItsRoundEnds) {
  const CadFace face =
      make_face({outline,
                 {curve::segment({-2, 0.2}, {2, 0.2}), curve::circular_arc({2, 0}, 0.2, half_pi, -half_pi),
                  curve::segment({2, -0.2}, {-2, -0.2}), curve::circular_arc({-2, 0}, 0.2, 1.5 * pi, half_pi)}});
  const std::vector<HoleFocus> foci = hole_foci(face);
  ASSERT_EQ(foci.size(), 2u);
  for (const HoleFocus& focus : foci) {
    EXPECT_EQ(focus.turns, 2);
    EXPECT_NEAR(std::abs(focus.position.x), 2.1, 1e-3);
    EXPECT_NEAR(focus.position.y, 0, 1e-6);
  }
}

}  // namespace
}  // namespace quadrille::field
