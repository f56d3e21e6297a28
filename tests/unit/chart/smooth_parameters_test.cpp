#include "chart/smooth_parameters.hpp"

#include <gtest/gtest.h>

#include "base/angle.hpp"
#include "space_faces.hpp"

namespace quadrille::chart {
namespace {

SpaceFace with_curve(const SpaceCurve& curve) {
  SpaceFace face;
  face.curves = {curve};
  face.boundary_edges = {{{0, 1}, 0, curve.begin(), curve.end()}};
  return with_smooth_parameters(std::move(face));
}

TEST(SmoothParameters, ACircleIsParametrisedByItsLength) {
  const SpaceCurve circle = tests::profile_arc(0, 2, 0, 2 * pi);
  EXPECT_TRUE(has_smooth_seam(circle));
  const SpaceFace face = with_curve(circle);
  const SpaceCurve& spline = face.curves[0];
  EXPECT_EQ(spline.degree, 7);
  EXPECT_EQ(spline.poles.front(), spline.poles.back());
  EXPECT_NEAR(face.boundary_edges[0].t1, 4 * pi, 1e-12);
  for (int k = 0; k <= 50; ++k) {
    const double t = 4 * pi * k / 50;
    EXPECT_LT(distance(surface::point(spline, t), {2 * std::cos(t / 2), 0, 2 * std::sin(t / 2)}), 2e-12);
  }
}

TEST(SmoothParameters, CurvesThatBendAtAKnotAndSmoothOnesRemain) {
  const SpaceCurve bent{
      2, {0, 0, 0, 1, 1, 2, 2, 2}, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {3, 1, 0}}, {1, 1, 1, 1, 1}};
  EXPECT_EQ(with_curve(bent).curves[0].poles, bent.poles);
  const SpaceCurve quarter = tests::profile_arc(0, 2, 0, 1.5);
  EXPECT_EQ(with_curve(quarter).curves[0].poles, quarter.poles);
  EXPECT_FALSE(has_smooth_seam(quarter));
}

}  // namespace
}  // namespace quadrille::chart
