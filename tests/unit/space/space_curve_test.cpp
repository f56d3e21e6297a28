#include "space/space_curve.hpp"

#include <gtest/gtest.h>

#include "../curved_surfaces.hpp"
#include "base/vec3.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::space {

namespace {

TEST(SpaceCurve, a_part_has_the_parameters_of_the_whole) {
  const SpaceCurve arc = tests::profile_arc(0, 2, 0, 3), part = trimmed(arc, 0.4, 2.9);
  EXPECT_EQ(part.begin(), 0.4);
  EXPECT_EQ(part.end(), 2.9);
  for (const double t : {0.4, 1.1, 1.5, 2.6, 2.9})
    EXPECT_LT(distance(surface::point(part, t), surface::point(arc, t)), 1e-15);
}

TEST(SpaceCurve, moved_ends_are_there_bit_for_bit) {
  const SpaceCurve arc = tests::profile_arc(0, 2, 0, 3);
  const Vec3 a{2, 1e-6, 0}, b = arc.poles.back() + Vec3{0, 0, 1e-6};
  const SpaceCurve moved = with_ends(arc, a, b);
  EXPECT_EQ(surface::point(moved, moved.begin()), a);
  EXPECT_EQ(surface::point(moved, moved.end()), b);
  EXPECT_EQ(moved.knots, arc.knots);
  EXPECT_LT(distance(surface::point(moved, 1.2), surface::point(arc, 1.2)), 2e-6);
}

TEST(SpaceCurve, kinks_are_knots_at_which_the_direction_jumps) {
  const SpaceCurve polyline{1, {0, 0, 1, 2, 3, 3}, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 0, 1}}, {1, 1, 1, 1}};
  EXPECT_EQ(tangent_jumps(polyline), std::vector<double>{2});
  EXPECT_TRUE(tangent_jumps(tests::profile_arc(0, 2, 0, 6)).empty());
}

}  // namespace

}  // namespace quadrille::space
