#include "chart/chart_outline.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"
#include "surface/nurbs_surface.hpp"
#include "surface_samples.hpp"

namespace quadrille::chart {
namespace {

TEST(OutlineTolerance, IsATenthOfTheErrorOfAnglesWithinItsLimits) {
  EXPECT_EQ(outline_tolerance(1e-6), 1e-7);
  EXPECT_EQ(outline_tolerance(0), 1e-9);
  EXPECT_EQ(outline_tolerance(1), rough_outline_tolerance);
}

/// A quarter of a circle in space over angles, with its image by other coordinates.
CurveSamples samples_of(const SpaceCurve& curve, int count) {
  CurveSamples samples;
  for (int i = 0; i <= count; ++i) {
    const double t = curve.begin() + (curve.end() - curve.begin()) * (1 - std::cos(pi * i / count)) / 2;
    const Vec3 x = surface::point(curve, t);
    samples.points.push_back({t, {x.x, x.z}});
  }
  const auto slope = [&](double t, bool at_end) {
    const Vec3 d = surface::derivatives(curve, t, at_end)[1];
    return Vec2{d.x, d.z};
  };
  samples.start_derivative = slope(curve.begin(), false), samples.end_derivative = slope(curve.end(), true);
  return samples;
}

TEST(FittedCurve, HasTheParametersOfTheCurveInSpace) {
  const SpaceCurve arc = tests::profile_arc(0, 2, 0, half_pi);
  const Nurbs curve = fitted_curve(arc, samples_of(arc, 200), 1e-8);
  for (int i = 0; i <= 30; ++i) {
    const double t = half_pi * i / 30;
    const Vec3 x = surface::point(arc, t);
    EXPECT_LT(distance(curve::point(curve, t), {x.x, x.z}), 1e-8);
  }
}

/// A circle that closes smoothly stays smooth at its seam.
TEST(FittedCurve, AClosedCurveIsPeriodic) {
  const SpaceCurve circle = tests::profile_arc(0, 1, 0, 2 * pi);
  const Nurbs curve = fitted_curve(circle, samples_of(circle, 400), 1e-8);
  EXPECT_EQ(curve.poles.front(), curve.poles.back());
  EXPECT_LT(distance(curve::tangent(curve, curve.begin()), curve::tangent(curve, curve.end(), true)), 1e-14);
}

TEST(FittedCurve, OfTooFewSamplesThereIsNone) {
  const SpaceCurve arc = tests::profile_arc(0, 2, 0, half_pi);
  EXPECT_THROW(fitted_curve(arc, samples_of(arc, 1), 1e-10), ComputeError);
}

TEST(SpaceAngle, OfACylindersPatchIsRight) {
  const SpaceFace face = cylinder_patch();
  for (int c = 0; c < 4; ++c) {
    const Vec3 x = face.curves[c].poles.front();
    EXPECT_NEAR(space_angle(face, c, normalized(Vec3{x.x, x.y, 0})), half_pi, 1e-12) << c;
    EXPECT_NEAR(space_angle(face, c, -normalized(Vec3{x.x, x.y, 0})), 3 * half_pi, 1e-12) << "from inside";
  }
}

/// Half of a great circle: the seam is smooth.
TEST(SpaceAngle, OfASmoothJointIsAHalfTurn) {
  const SpaceFace face = cap();
  EXPECT_NEAR(space_angle(face, 0, face.curves[0].poles.front()), pi, 1e-12);
}

CadFace square() {
  CadFace face;
  const std::array<Vec2, 4> p{{{0, 0}, {3, 0}, {3, 4}, {0, 4}}};
  for (int k = 0; k < 4; ++k) face.curves.push_back(curve::segment(p[k], p[(k + 1) % 4]));
  face.loop_offsets = {0, 4};
  return face;
}

TEST(JointOf, IsACornerBeyondTheAngle) {
  const Joint corner = joint_of(square(), 1, half_pi, radians(1));
  EXPECT_EQ(corner.position, (Vec2{3, 0}));
  EXPECT_NEAR(corner.tangent_in, 0, 1e-15);
  EXPECT_NEAR(corner.tangent_out, half_pi, 1e-15);
  EXPECT_TRUE(corner.is_corner);
  EXPECT_FALSE(joint_of(square(), 1, pi - radians(1), radians(1)).is_corner)
      << "an angle equal to the limit is no corner";
  EXPECT_TRUE(joint_of(square(), 1, pi + radians(1.01), radians(1)).is_corner);
}

TEST(OutlineDiameter, IsThatOfTheFirstLoop) {
  CadFace face = square();
  EXPECT_EQ(outline_diameter(face), 5);
  face.curves.push_back(curve::segment({0, 0}, {100, 0}));
  face.loop_offsets.push_back(5);
  EXPECT_EQ(outline_diameter(face), 5);
}

/// The rough image of a cylinder, 4 x 3, with the names and parameters of the curves in space.
TEST(OutlineOfImage, HasTheCurvesOfTheFaceAndTheirAngles) {
  const SurfaceSample sample(cylinder_patch());
  const CadFace face =
      outline_of_image(sample.face, sample.lengths, sample.rough, {rough_outline_tolerance, radians(1)});
  ASSERT_EQ(face.num_curves(), 4);
  EXPECT_NEAR(face.diameter, 5, 0.02);
  for (int c = 0; c < 4; ++c) {
    EXPECT_EQ(face.curve_names[c], sample.face.face.curve_names[c]);
    EXPECT_EQ(face.curves[c].begin(), sample.face.curves[c].begin());
    EXPECT_EQ(face.curves[c].end(), sample.face.curves[c].end());
    EXPECT_NEAR(face.joints[c].interior_angle, half_pi, 1e-9);
    EXPECT_EQ(face.curves[c].poles.back(), face.curves[(c + 1) % 4].poles.front());
  }
}

}  // namespace
}  // namespace quadrille::chart
