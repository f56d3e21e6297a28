#include "field/hole_foci.hpp"

#include <gtest/gtest.h>

#include "../triangulate/faces.hpp"

namespace quadrille::field {
namespace {

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
