#include "surface/periodic_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../chart_samples.hpp"
#include "base/angle.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::surface {
namespace {

/// Curve 0 of the sphere's patch and its image under a motion, backwards: curve 1.
Chart with_image(const SpaceMotion& motion, SpaceCurve curve) {
  Chart chart = *samples::sphere_face().chart;
  chart.space_curves = {curve, reversed(curve)};
  for (Vec3& pole : chart.space_curves[1].poles) pole = image(motion, pole);
  return chart;
}

SpaceCurve bent() { return samples::sphere_face().chart->space_curves[1]; }

/// About the axis (1, 2, 2) / 3, through a point off the origin.
SpaceMotion turn(double angle) {
  const Vec3 d{1.0 / 3, 2.0 / 3, 2.0 / 3};
  const double c = std::cos(angle), s = std::sin(angle), r = 1 - c;
  return {{Vec3{c + r * d.x * d.x, r * d.x * d.y - s * d.z, r * d.x * d.z + s * d.y},
           Vec3{r * d.y * d.x + s * d.z, c + r * d.y * d.y, r * d.y * d.z - s * d.x},
           Vec3{r * d.z * d.x - s * d.y, r * d.z * d.y + s * d.x, c + r * d.z * d.z}},
          {0.3, -1, 2}};
}

void expect_near(const SpaceMotion& a, const SpaceMotion& b) {
  for (int k = 0; k < 3; ++k) EXPECT_LE(distance(a.matrix[k], b.matrix[k]), 1e-13);
  EXPECT_LE(distance(a.shift, b.shift), 1e-13);
}

TEST(PeriodicMotion, ARotationOfACurveIsFoundWhateverItsAngle) {
  for (const double angle : {0.4, pi / 3, 2.9, pi}) {
    const Chart chart = with_image(turn(angle), bent());
    expect_near(motion_between(chart, {0}, {1}), turn(angle));
    EXPECT_NEAR(rotation_axis(motion_between(chart, {0}, {1})).angle, angle, 1e-14);
  }
}

TEST(PeriodicMotion, ATranslationHasNoAngleAtAll) {
  const SpaceMotion shift{SpaceMotion().matrix, {0.1, -2, 3}};
  const SpaceMotion found = motion_between(with_image(shift, bent()), {0}, {1});
  EXPECT_EQ(found.matrix, shift.matrix);
  EXPECT_LE(distance(found.shift, shift.shift), 1e-15);
}

TEST(PeriodicMotion, TheAngleIsAWholeFractionOfATurnIfItIsNearOne) {
  const SpaceMotion found = motion_between(with_image(turn(2 * pi / 7 + 1e-11), bent()), {0}, {1});
  EXPECT_NEAR(rotation_axis(found).angle, 2 * pi / 7, 1e-15);
}

TEST(PeriodicMotion, SidesOfOnePatchAreMappedByItsNormalsWhereTheyAreLines) {
  // Chords of the meridians y = 0 and x = 0 of the sphere: a quarter turn about the z axis.
  const Vec3 pole{0, 0, 1}, east{0.8, 0, 0.6}, north{0, 0.8, 0.6};
  Chart chart = *samples::sphere_face().chart;
  chart.space_curves = {{1, {0, 0, 1, 1}, {pole, east}, {1, 1}}, {1, {0, 0, 1, 1}, {north, pole}, {1, 1}}};
  const SpaceMotion found = motion_between(chart, {0}, {1});
  expect_near(found, {{Vec3{0, -1, 0}, Vec3{1, 0, 0}, Vec3{0, 0, 1}}, {0, 0, 0}});
}

TEST(PeriodicMotion, TheOriginalIsTheInverseOfTheImage) {
  const Vec3 x{0.2, 5, -1};
  EXPECT_LE(distance(original(turn(1), image(turn(1), x)), x), 1e-14);
}

}  // namespace
}  // namespace quadrille::surface
