#include "chart/smooth_parameters.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

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

// A hyperbola on a cone, of one rational piece to which a knot is added that changes nothing.
TEST(SmoothParameters, SpansAreShortWhereTheCurveBends) {
  constexpr double at = 0.35;
  const std::array<Vec3, 3> poles{{{0.5, std::sqrt(0.75), 0}, {0.5, 0, 1.5}, {0.5, -std::sqrt(0.75), 0}}};
  const std::array<double, 3> weights{1, 2, 1};
  SpaceCurve curve{2, {0, 0, 0, at, 1, 1, 1}, {poles[0]}, {1}};
  for (int k = 0; k < 2; ++k) {
    const double w = (1 - at) * weights[k] + at * weights[k + 1];
    curve.weights.push_back(w);
    curve.poles.push_back(((1 - at) * weights[k] * poles[k] + at * weights[k + 1] * poles[k + 1]) / w);
  }
  curve.poles.push_back(poles[2]), curve.weights.push_back(1);
  const SpaceFace face = with_curve(curve);
  const SpaceCurve& spline = face.curves[0];
  ASSERT_EQ(spline.degree, 7);
  std::vector<double> spans;
  for (std::size_t k = 1; k < spline.knots.size(); ++k)
    if (spline.knots[k] > spline.knots[k - 1]) spans.push_back(spline.knots[k] - spline.knots[k - 1]);
  const auto [shortest, longest] = std::minmax_element(spans.begin(), spans.end());
  EXPECT_GT(*longest, 3 * *shortest);
  // The cone of radius 1 - z / 2.
  for (int k = 0; k <= 1000; ++k) {
    const Vec3 x = surface::point(spline, spline.end() * k / 1000);
    EXPECT_NEAR(x.x, 0.5, 1e-11);
    EXPECT_NEAR(std::hypot(x.x, x.y), 1 - x.z / 2, 1e-11);
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
