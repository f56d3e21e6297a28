#include "sew/joined_curve.hpp"

#include <gtest/gtest.h>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::sew {
namespace {

TEST(JoinedCurve, IsTheCircleAcrossItsSeam) {
  const Nurbs circle = curve::circular_arc({1, 2}, 3, 0, 2 * pi);
  const Nurbs tail = curve::trimmed(circle, 5, circle.end()), head = curve::trimmed(circle, 0, 1);
  const Nurbs joined = joined_curve(tail, head);
  EXPECT_EQ(joined.knots.size(), joined.poles.size() + 3);
  EXPECT_EQ(joined.weights.size(), joined.poles.size());
  EXPECT_NEAR(joined.end() - joined.begin(), 2 * pi - 4, 1e-14);
  for (double t = joined.begin(); t <= joined.end(); t += 0.05)
    EXPECT_NEAR(distance(curve::point(joined, t), {1, 2}), 3, 1e-14);
  EXPECT_NEAR(distance(curve::point(joined, 2 * pi + 0.5), curve::point(circle, 0.5)), 0, 1e-14);
  EXPECT_TRUE(curve::smoothness_breaks(joined).empty());
}

TEST(JoinedCurve, RefusesDifferentDegrees) {
  EXPECT_THROW(joined_curve(curve::segment({0, 0}, {1, 0}), curve::circular_arc({0, 0}, 1, 0, 1)), Defect);
}

}  // namespace
}  // namespace quadrille::sew
