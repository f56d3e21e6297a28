#include "offset/offset_chain.hpp"

#include <gtest/gtest.h>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"
#include "curve/pole_box.hpp"
#include "curve/project.hpp"

namespace quadrille::offset {

namespace {

TEST(ExtendedCurve, GoesOnStraight) {
  const Nurbs arc = curve::circular_arc({0, 0}, 2, 0, pi / 2);
  const ExtendedCurve extended(arc);
  EXPECT_NEAR(distance(extended.point(extended.beside_start(-1)), {2, -1}), 0, 1e-12);
  EXPECT_NEAR(distance(extended.point(extended.beside_end(1)), {-1, 2}), 0, 1e-12);
}

TEST(ExtendedCurve, CrossesInsideAndBeyondTheEnds) {
  const Nurbs a = curve::segment({0, 0}, {2, 0}), b = curve::segment({1, 1}, {1, 3});
  const auto crossing = crossing_near(ExtendedCurve(a), 0, ExtendedCurve(b), 0, 1e-12);
  ASSERT_TRUE(crossing);
  EXPECT_NEAR(crossing->t_a, 1, 1e-12);
  EXPECT_NEAR(crossing->t_b, -1, 1e-12);
  EXPECT_FALSE(crossing_near(ExtendedCurve(a), 0, ExtendedCurve(curve::segment({0, 1}, {2, 1})), 0, 1e-12));
}

OffsetProfile constant(double distance) { return {distance, true, {}}; }

TEST(OffsetCurve, OfALineIsALine) {
  const Nurbs offset = offset_curve(curve::segment({1, 0}, {3, 0}), constant(0.5), 1e-9, "x", {});
  EXPECT_EQ(offset.degree, 1);
  EXPECT_NEAR(distance(offset.poles.front(), {1, 0.5}), 0, 1e-15);
  EXPECT_NEAR(distance(offset.poles.back(), {3, 0.5}), 0, 1e-15);
}

TEST(OffsetCurve, OfAnArcIsAnArcOnBothSides) {
  for (const bool turns_left : {true, false}) {
    const Nurbs arc = curve::circular_arc({1, 2}, 2, turns_left ? 0 : 2, turns_left ? 2 : 0);
    const curve::Carrier carrier = curve::carrier_of(offset_curve(arc, constant(0.5), 1e-9, "x", {}));
    EXPECT_EQ(carrier.kind, curve::CurveKind::arc);
    EXPECT_NEAR(carrier.radius, turns_left ? 1.5 : 2.5, 1e-12);
    EXPECT_NEAR(distance(carrier.point, {1, 2}), 0, 1e-12);
  }
}

TEST(OffsetCurve, OfASplineIsAtTheDistanceEverywhere) {
  const Nurbs wave =
      curve::cubic_spline({0, 1, 2, 3, 4}, {{0, 0}, {1, 0.3}, {2, 0}, {3, -0.3}, {4, 0}}, {1, 0.4}, {1, 0.4});
  const Nurbs offset = offset_curve(wave, constant(0.2), 1e-7, "x", {});
  for (int i = 1; i < 200; ++i) {
    const Vec2 x = curve::point(offset, offset.begin() + (offset.end() - offset.begin()) * i / 200);
    EXPECT_NEAR(curve::project(wave, x).distance, 0.2, 2e-7);
  }
}

TEST(OffsetCurve, ABendNarrowerThanTheDistanceIsRefused) {
  const Nurbs arc = curve::circular_arc({0, 0}, 1, 0, 1);
  EXPECT_THROW(offset_curve(arc, constant(1), 1e-9, "x", {}), ComputeError);
}

}  // namespace

}  // namespace quadrille::offset
