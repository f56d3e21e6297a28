#include "outline/extent.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::outline {
namespace {

Nurbs turned(Nurbs curve, double angle) {
  for (Vec2& p : curve.poles) p = p.x * unit(angle) + p.y * left_of(unit(angle));
  return curve;
}

// A D: a half ellipse with half axes 1 and 3 over the y axis, whose farthest points lie on no knot.
std::vector<Nurbs> lens() {
  Nurbs arc = curve::circular_arc({0, 0}, 1, -1.2, 1.7);
  for (Vec2& p : arc.poles) p.y *= 3;
  return {arc, curve::segment(arc.poles.back(), arc.poles.front())};
}

TEST(Extent, area_of_a_disc_has_the_sign_of_its_direction) {
  EXPECT_NEAR(signed_area({curve::circular_arc({5, 5}, 2, 0.3, 0.3 + 2 * pi)}), 4 * pi, 1e-13);
  EXPECT_NEAR(signed_area({curve::circular_arc({5, 5}, 2, 0.3, 0.3 - 2 * pi)}), -4 * pi, 1e-13);
}

TEST(Extent, area_of_a_face_is_that_without_its_holes) {
  CadFace face;
  face.curves = {curve::circular_arc({5, 5}, 2, 0, 2 * pi), curve::circular_arc({5, 5}, 1, 0, -2 * pi)};
  face.loop_offsets = {0, 1, 2};
  EXPECT_NEAR(area(face), 3 * pi, 1e-13);
}

TEST(Extent, diameter_of_disc_and_rectangle) {
  EXPECT_NEAR(diameter({curve::circular_arc({1, 2}, 3, 0.4, 0.4 + 2 * pi)}), 6, 1e-14);
  const std::vector<Vec2> p{{0, 0}, {3, 0}, {3, 4}, {0, 4}};
  std::vector<Nurbs> sides;
  for (int i = 0; i < 4; ++i) sides.push_back(curve::segment(p[i], p[(i + 1) % 4]));
  EXPECT_NEAR(diameter(sides), 5, 1e-15);
}

TEST(Extent, diameter_does_not_change_when_the_shape_is_turned) {
  const double d = diameter(lens());
  EXPECT_GT(d, 5.5);
  for (int i = 1; i < 40; ++i) {
    std::vector<Nurbs> curves;
    for (const Nurbs& curve : lens()) curves.push_back(turned(curve, 0.37 * i));
    EXPECT_NEAR(diameter(curves), d, 1e-14);
  }
}

}  // namespace
}  // namespace quadrille::outline
