#include "offset/offset_chain.hpp"

#include <gtest/gtest.h>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"

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

}  // namespace

}  // namespace quadrille::offset
