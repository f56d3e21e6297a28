#include "offset/offset_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../chart_samples.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"
#include "curve/pole_box.hpp"
#include "curve/project.hpp"

namespace quadrille::offset {
namespace {

Nurbs offset_of(const Nurbs& curve, double distance, double tolerance) {
  return offset_curve({}, curve, {distance, true, {}}, ChartHeights({}), tolerance, "x");
}

TEST(OffsetCurve, OfALineIsALine) {
  const Nurbs offset = offset_of(curve::segment({1, 0}, {3, 0}), 0.5, 1e-9);
  EXPECT_EQ(offset.degree, 1);
  EXPECT_NEAR(distance(offset.poles.front(), {1, 0.5}), 0, 1e-15);
  EXPECT_NEAR(distance(offset.poles.back(), {3, 0.5}), 0, 1e-15);
}

TEST(OffsetCurve, OfAnArcIsAnArcOnBothSides) {
  for (const bool turns_left : {true, false}) {
    const Nurbs arc = curve::circular_arc({1, 2}, 2, turns_left ? 0 : 2, turns_left ? 2 : 0);
    const curve::Carrier carrier = curve::carrier_of(offset_of(arc, 0.5, 1e-9));
    EXPECT_EQ(carrier.kind, curve::CurveKind::arc);
    EXPECT_NEAR(carrier.radius, turns_left ? 1.5 : 2.5, 1e-12);
    EXPECT_NEAR(distance(carrier.point, {1, 2}), 0, 1e-12);
  }
}

TEST(OffsetCurve, OfASplineIsAtTheDistanceEverywhere) {
  const Nurbs wave =
      curve::cubic_spline({0, 1, 2, 3, 4}, {{0, 0}, {1, 0.3}, {2, 0}, {3, -0.3}, {4, 0}}, {1, 0.4}, {1, 0.4});
  const Nurbs offset = offset_of(wave, 0.2, 1e-7);
  for (int i = 1; i < 200; ++i) {
    const Vec2 x = curve::point(offset, offset.begin() + (offset.end() - offset.begin()) * i / 200);
    EXPECT_NEAR(curve::project(wave, x).distance, 0.2, 2e-7);
  }
}

TEST(OffsetCurve, ABendNarrowerThanTheDistanceIsRefused) {
  const Nurbs arc = curve::circular_arc({0, 0}, 1, 0, 1);
  EXPECT_THROW(offset_of(arc, 1, 1e-9), ComputeError);
}

// A circle of latitude: the chart is the stereographic one, in which it is a circle too.
TEST(OffsetCurve, OnASphereIsAtTheDistanceInSpace) {
  const CadFace cap = samples::cap_face();
  const Nurbs offset = offset_curve(cap, cap.curves[1], {0.3, true, {}}, ChartHeights(cap), 1e-7, "x");
  for (int i = 0; i <= 50; ++i) {
    const double radius = norm(curve::point(offset, offset.begin() + (offset.end() - offset.begin()) * i / 50));
    EXPECT_NEAR(2 * (std::atan(0.8) - std::atan(radius)), 0.3, 2e-7);
  }
}

}  // namespace
}  // namespace quadrille::offset
