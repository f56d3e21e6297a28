#include "guide/valence.hpp"

#include <gtest/gtest.h>

#include <complex>

#include "../support/square_field.hpp"
#include "base/error.hpp"

namespace quadrille::guide {
namespace {

TEST(TieDistance, is_zero_at_odd_multiples_of_45_degrees) {
  for (const double tie : {45.0, 135.0, 225.0, 315.0}) {
    EXPECT_NEAR(tie_distance(radians(tie)), 0, 1e-14);
    EXPECT_NEAR(tie_distance(radians(tie + 7)), radians(7), 1e-14);
    EXPECT_NEAR(tie_distance(radians(tie - 7)), radians(7), 1e-14);
  }
  EXPECT_NEAR(tie_distance(half_pi), pi / 4, 1e-14);
}

/// One triangle with 45 degrees at 0 between the x axis (outgoing) and the diagonal (incoming), and the field that
/// goes on the chord from (1, 0) to (-1, 0), moved sideways by c r^4 sin 4 theta.
Field wedge_field(double c) {
  const std::array<Vec2, 3> p{Vec2{0, 0}, Vec2{1, 0}, Vec2{0.6, 0.6}};
  TriMesh mesh;
  mesh.face.diameter = 1;
  mesh.face.loop_offsets = {0, 3};
  mesh.vertices = {p[0], p[1], p[2]};
  mesh.elem2vertices = {{0, 1, 2}};
  for (int i = 0; i < 3; ++i) {
    const Vec2 before = p[(i + 2) % 3], after = p[(i + 1) % 3];
    mesh.face.curves.push_back(curve::segment(p[i], after));
    mesh.boundary_edges.push_back({0, i, i, 0, distance(p[i], after)});
    const double out = angle_of(after - p[i]), angle = wrap_two_pi(angle_of(before - p[i]) - out);
    mesh.face.joints.push_back({p[i], angle_of(p[i] - before), out, angle, true});
  }
  const Vec2 pole = -3 * unit(pi / 8);
  const double slope = -8 / pi;  // of u by the polar angle
  Field field = interpolated_field(mesh, 14, [&](Vec2 x) {
    const double side = c * std::pow(std::complex(x.x, x.y), 4).imag();
    return Vec2{1 + slope * angle_of(x - pole), side};
  });
  field.liftings = {{0, {0, 0}, pole, {slope, 0}}};
  return field;
}

TEST(CornerValences, a_tie_is_decided_by_the_next_term) {
  for (const double c : {3.0, 0.5}) {
    const Field smaller = wedge_field(c), larger = wedge_field(-c);
    EXPECT_EQ(corner_valences(field::FieldEvaluator(smaller)).corners[0].valence, 0);
    EXPECT_EQ(corner_valences(field::FieldEvaluator(larger)).corners[0].valence, 1);
  }
}

TEST(CornerValences, away_from_ties_is_the_nearest_integer) {
  const Field field = wedge_field(1);
  const std::vector<Corner> corners = corner_valences(field::FieldEvaluator(field)).corners;
  ASSERT_EQ(corners.size(), 3u);
  EXPECT_NEAR(corners[1].angle_degrees, degrees(std::atan2(0.6, 0.4)), 1e-12);
  EXPECT_EQ(corners[1].valence, 1);  // 56.3 degrees
  EXPECT_EQ(corners[2].valence, 1);  // 78.7 degrees
}

TEST(CornerValences, a_tie_that_the_field_leaves_open_is_an_error) {
  const Field field = wedge_field(0);
  EXPECT_THROW(corner_valences(field::FieldEvaluator(field)), ComputeError);
}

}  // namespace
}  // namespace quadrille::guide
