#include "field/boundary_values.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"
#include "field/explicit_value.hpp"

namespace quadrille::field {
namespace {

CadFace half_disc() {
  CadFace face;
  face.diameter = 2;
  face.curves = {curve::segment({-1, 0}, {1, 0}), curve::circular_arc({0, 0}, 1, 0, pi)};
  face.joints = {{{-1, 0}, -half_pi, 0, half_pi, true}, {{1, 0}, 0, half_pi, half_pi, true}};
  face.loop_offsets = {0, 2};
  return face;
}

TEST(BoundaryValues, StraightSidesOnTheAxesAreExact) {
  const Vec2 value = boundary_value(half_disc(), 0, 0.3);
  EXPECT_EQ(value.x, 1);
  EXPECT_EQ(value.y, 0);
}

TEST(BoundaryValues, FollowTheTangentOfAnArc) {
  const CadFace face = half_disc();
  for (const double t : {0.0, 0.1, 1.0, 2.5, pi}) {
    // The tangent at polar angle t is t + 90 degrees: the same cross.
    const Vec2 value = boundary_value(face, 1, t);
    EXPECT_NEAR(distance(value, unit(4 * angle_of(curve::point(face.curves[1], t)))), 0, 2e-15);
    EXPECT_NEAR(norm(value), 1, 1e-15);
  }
}

TEST(BoundaryValues, SubtractTheLiftingOfAnotherJoint) {
  const CadFace face = half_disc();
  const std::vector<Lifting> liftings{{1, {1, 0}, {2, -1}, {0.5, -2}}};
  const Vec2 x = curve::point(face.curves[0], 1.5);
  const double angle = std::arg(std::complex<double>(x.x - 1, x.y) / std::complex<double>(x.x - 2, x.y + 1));
  const Vec2 value = lifted_boundary_value(face, liftings, 0, 1.5);
  EXPECT_NEAR(value.x, 1 - 0.5 * angle, 1e-15);
  EXPECT_NEAR(value.y, 2 * angle, 1e-15);
}

CadFace polygon(const std::vector<Vec2>& corners) {
  CadFace face;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    face.curves.push_back(curve::segment(corners[i], corners[(i + 1) % corners.size()]));
  }
  return face;
}

TEST(BoundaryValues, ParametersWithinRoundingOfAnEndAreTheEnd) {
  CadFace face = polygon({{0, 0}, {2, 0}, {1.3, 1.1}});
  face.diameter = 2;
  face.loop_offsets = {0, 3};
  const Lifting lifting{1, {2, 0}, {3, -0.5}, {1, 0}};
  const double end = face.curves[0].end();
  EXPECT_NEAR(distance(lifted_boundary_value(face, {lifting}, 0, end * (1 - 1e-13)),
                       lifted_boundary_value(face, {lifting}, 0, end)),
              0, 1e-15);
}

TEST(BoundaryValues, DataOnALineAreNoticed) {
  EXPECT_TRUE(is_line_field(polygon({{0, 0}, {2, 0}, {2, 1}, {1, 2}, {0, 2}})));               // 45 degree chamfer
  EXPECT_FALSE(is_line_field(polygon({{0, 0}, {1, 0.5}, {0.75, 1}, {0.5, 1}})));               // general angles
  EXPECT_FALSE(is_line_field(polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}})));                      // one parity: constant
  EXPECT_FALSE(is_line_field(polygon({{0, 0}, {2, 0}, {2, 1}, {1, 2.00001}, {0, 2.00001}})));  // nearly
  EXPECT_FALSE(is_line_field(half_disc()));
}

// A face bounded by polygons: loop 0 counter-clockwise, the others clockwise.
CadFace polygon_face(const std::vector<std::vector<Vec2>>& loops, double diameter) {
  CadFace face;
  face.diameter = diameter;
  face.loop_offsets = {0};
  for (const std::vector<Vec2>& loop : loops) {
    const std::size_t n = loop.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Vec2 a = loop[(i + n - 1) % n], b = loop[i], c = loop[(i + 1) % n];
      face.curves.push_back(curve::segment(b, c));
      const double in = angle_of(b - a), out = angle_of(c - b);
      face.joints.push_back({b, in, out, pi - wrap_pi(out - in), true});
    }
    face.loop_offsets.push_back(face.num_curves());
  }
  return face;
}

const std::vector<Vec2> rhombus{{0, 0}, {2, 0}, {3, 1.5}, {1, 1.5}};
const std::vector<Vec2> triangular_hole{{1.2, 0.5}, {1.5, 1.1}, {1.9, 0.6}};

TEST(CornerLifting, RightAnglesNeedNone) {
  EXPECT_TRUE(corner_liftings(polygon_face({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}, std::sqrt(2.0))).empty());
}

TEST(CornerLifting, LeavesContinuousDataAtEveryJoint) {
  const CadFace face = polygon_face({rhombus, triangular_hole}, 3.4);
  const std::vector<Lifting> liftings = corner_liftings(face);
  ASSERT_EQ(liftings.size(), 7u);
  for (int joint = 0; joint < face.num_curves(); ++joint) {
    const int before = face.previous_in_loop(joint);
    const Vec2 in = lifted_boundary_value(face, liftings, before, face.curves[before].end());
    const Vec2 out = lifted_boundary_value(face, liftings, joint, face.curves[joint].begin());
    EXPECT_NEAR(distance(in, out), 0, 1e-14);
    EXPECT_GT(distance(boundary_value(face, before, face.curves[before].end()),
                       boundary_value(face, joint, face.curves[joint].begin())),
              0.1);
    // The limits at the joint are those of the data nearby.
    const double near = 1e-9;
    EXPECT_NEAR(distance(out, lifted_boundary_value(face, liftings, joint, near)), 0, 1e-6);
  }
}

TEST(CornerLifting, ARayThatTouchesACornerEndsThere) {
  // Half of the way to the opposite corner (0, 2) would be the corner at (1, 1).
  const CadFace face = polygon_face(
      {{{-3, -3}, {5, -3}, {5, 5}, {-3, 5}}, {{0, 0}, {0, 2}, {1, 2}, {1, 1}, {2, 1}, {2, 0}}}, 8 * std::sqrt(2.0));
  for (const double off : {-1e-13, 0.0, 1e-13})
    EXPECT_NEAR(distance(half_way(face, {2, 0}, unit(3 * half_pi / 2 + off)), {1.5, 0.5}), 0, 1e-5) << off;
}

TEST(CornerLifting, JumpsByTheInteriorAngleAtItsApex) {
  const CadFace face = polygon_face({rhombus, triangular_hole}, 3.4);
  for (const Lifting& lifting : corner_liftings(face)) {
    const Joint& joint = face.joints[lifting.joint];
    const double outgoing = lifting_angle_at_apex(lifting, unit(joint.tangent_out));
    const double incoming = lifting_angle_at_apex(lifting, -unit(joint.tangent_in));
    EXPECT_NEAR(incoming - outgoing, joint.interior_angle, 1e-14);
    const Vec2 jump = cross_value(joint.tangent_in) - cross_value(joint.tangent_out);
    EXPECT_NEAR(distance(joint.interior_angle * lifting.jump, jump), 0, 1e-14);
  }
}

TEST(CornerLifting, IsSingleValuedAroundTheHoleThatCarriesIt) {
  const CadFace face = polygon_face({rhombus, triangular_hole}, 3.4);
  for (const Lifting& lifting : corner_liftings(face)) {
    // A circle in the domain, around the hole; steps small enough that a cut would show as a jump of 2 pi.
    double last = lifting_angle(lifting, Vec2{1.53, 0.74} + Vec2{0.45, 0});
    for (int i = 1; i <= 400; ++i) {
      const double angle = lifting_angle(lifting, Vec2{1.53, 0.74} + 0.45 * unit(2 * pi * i / 400));
      EXPECT_LT(std::abs(angle - last), 0.3);
      last = angle;
    }
  }
}

TEST(CornerLifting, PolesStayInsideTheirHoleOrWithinOneDiameter) {
  const CadFace face = polygon_face({rhombus, triangular_hole}, 3.4);
  for (const Lifting& lifting : corner_liftings(face)) {
    const double reach = distance(lifting.apex, lifting.pole);
    EXPECT_LE(reach, face.diameter * (1 + 1e-12));
    if (lifting.joint < 4) {
      EXPECT_NEAR(reach, face.diameter, 1e-12);  // nothing lies outside a convex outline
    } else {
      for (int i = 0; i < 3; ++i) {  // clockwise hole: its inside is on the right of each side
        const Vec2 a = triangular_hole[i], b = triangular_hole[(i + 1) % 3];
        EXPECT_LT(cross(b - a, lifting.pole - a), -0.01);
      }
    }
  }
}

TEST(CornerLifting, PoleGoesHalfWayToACurvedObstacle) {
  // A V-shaped notch under an arc that closes over it: the ray from the notch's apex meets the arc.
  CadFace face = polygon_face({{{-1, -1}, {1, -1}, {0.8, 1}, {0, 0}, {-0.8, 1}}}, 3);
  face.curves.push_back(curve::circular_arc({0, 1}, 0.5, 1.2 * pi, 1.9 * pi));
  face.joints.push_back({curve::point(face.curves.back(), face.curves.back().begin()), 0, 0, pi, false});
  face.loop_offsets.push_back(6);
  const std::vector<Lifting> liftings = corner_liftings(face);
  const auto notch = std::find_if(liftings.begin(), liftings.end(), [](const Lifting& l) { return l.joint == 3; });
  ASSERT_NE(notch, liftings.end());
  EXPECT_NEAR(distance(notch->pole, {0, 0.25}), 0, 1e-5);
}

TEST(CornerLifting, GradientMatchesDifferencesAndIsHarmonic) {
  const Lifting lifting{0, {0.3, 0.1}, {-0.5, -0.4}, {1, 0}};
  const Vec2 x{1.1, 0.7};
  const double h = 1e-5;
  const Vec2 g = lifting_gradient(lifting, x);
  EXPECT_NEAR(g.x, (lifting_angle(lifting, {x.x + h, x.y}) - lifting_angle(lifting, {x.x - h, x.y})) / (2 * h), 1e-9);
  EXPECT_NEAR(g.y, (lifting_angle(lifting, {x.x, x.y + h}) - lifting_angle(lifting, {x.x, x.y - h})) / (2 * h), 1e-9);
  const double divergence =
      (lifting_gradient(lifting, {x.x + h, x.y}).x - lifting_gradient(lifting, {x.x - h, x.y}).x +
       lifting_gradient(lifting, {x.x, x.y + h}).y - lifting_gradient(lifting, {x.x, x.y - h}).y) /
      (2 * h);
  EXPECT_NEAR(divergence, 0, 1e-9);
}

}  // namespace
}  // namespace quadrille::field
