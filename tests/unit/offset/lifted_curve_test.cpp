#include "offset/lifted_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../chart_samples.hpp"
#include "base/angle.hpp"
#include "curve/nurbs.hpp"
#include "surface/nurbs_surface.hpp"
#include "surface/space_extent.hpp"

namespace quadrille::offset {
namespace {

/// Half of the cap of the unit sphere whose chart is the disc of radius 0.8.
struct LiftedCurve : testing::Test {
  CadFace face = samples::cap_face();
  mesh::ChartMap map{face};

  /// Checks the curve in space against the exact one.
  SpaceCurve lifted(const Nurbs& image, double on_surface = 1e-11) const {
    SpaceCurve curve = lifted_curve(map, face, image);
    EXPECT_EQ(curve.begin(), image.begin());
    EXPECT_EQ(curve.end(), image.end());
    for (int k = 0; k <= 50; ++k) {
      const double t = image.begin() + (image.end() - image.begin()) * k / 50;
      const Vec3 x = surface::point(curve, t);
      EXPECT_NEAR(norm(x), 1, on_surface) << "on the sphere";
      EXPECT_LT(distance(x, samples::on_sphere(curve::point(image, t))), 1e-7) << t;
    }
    return curve;
  }
};

TEST_F(LiftedCurve, ALineInsideIsACurveOnTheSurface) {
  const Nurbs image = samples::line({-0.3, 0.2}, {0.4, 0.3});
  const SpaceCurve curve = lifted(image);
  EXPECT_EQ(curve.poles.front(), map.lift({-0.3, 0.2}));
}

TEST_F(LiftedCurve, ACircleThatClosesSmoothlyStaysSmooth) {
  const Nurbs image = curve::circular_arc({0, 0.35}, 0.2, 0, 2 * pi);
  const SpaceCurve curve = lifted(image, 1e-9);  // parameters of the arcs have few derivatives
  const auto begin = surface::derivatives(curve, curve.begin()), end = surface::derivatives(curve, curve.end());
  EXPECT_LT(distance(begin[0], end[0]), 1e-12);
  EXPECT_LT(distance(normalized(begin[1]), normalized(end[1])), 1e-7);
}

/// From the middle of the axis to the rim, along the mirror axis of the cap.
TEST_F(LiftedCurve, EndsOnTheBoundaryAreThereInSpace) {
  const Nurbs image = samples::line({0.1, 0}, {0.1, std::sqrt(0.64 - 0.01)});
  const SpaceCurve curve = lifted(image);
  EXPECT_LT(surface::project(face.chart->space_curves[0], curve.poles.front()).distance, 1e-15);
  double off = 1;
  for (const int rim : {1, 2})
    off = std::min(off, surface::project(face.chart->space_curves[rim], curve.poles.back()).distance);
  EXPECT_LT(off, 1e-15);
}

}  // namespace
}  // namespace quadrille::offset
