#include "sew/crossings.hpp"

#include <gtest/gtest.h>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::sew {
namespace {

TEST(Crossings, OfALineAndACircleAreExact) {
  const Nurbs circle = curve::circular_arc({0, 0}, 1, 0, 2 * pi), line = curve::segment({-2, 0.6}, {2, 0.6});
  const auto found = crossings(line, circle, 1e-6, "x");
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(distance(found[0].position, {-0.8, 0.6}), 0, 1e-14);
  EXPECT_NEAR(distance(found[1].position, {0.8, 0.6}), 0, 1e-14);
  EXPECT_NEAR(distance(curve::point(circle, found[1].t_b), {0.8, 0.6}), 0, 1e-14);
}

TEST(Crossings, AtKnotsCountOnce) {
  const Nurbs circle = curve::circular_arc({0, 0}, 1, 0, 2 * pi), line = curve::segment({0, -2}, {0, 2});
  EXPECT_EQ(crossings(line, circle, 1e-6, "x").size(), 2U);
  EXPECT_EQ(crossings(circle, line, 1e-6, "x").size(), 2U);
}

TEST(Crossings, OfDistantOrParallelLinesAreNone) {
  EXPECT_TRUE(crossings(curve::segment({0, 0}, {1, 0}), curve::segment({0, 1}, {1, 1}), 1e-6, "x").empty());
  EXPECT_TRUE(crossings(curve::segment({0, 0}, {1, 0}), curve::segment({2, -1}, {2, 1}), 1e-6, "x").empty());
}

TEST(Crossings, CurvesAlongEachOtherAreRefused) {
  const Nurbs circle = curve::circular_arc({0, 0}, 1, 0, 2 * pi), arc = curve::circular_arc({0, 0}, 1, 1, 2);
  EXPECT_THROW(crossings(circle, arc, 1e-6, "edges 1 and 2"), FormatError);
  EXPECT_THROW(crossings(circle, curve::segment({-1, 1 - 1e-9}, {1, 1 - 1e-9}), 1e-6, "edges 1 and 2"), FormatError);
}

}  // namespace
}  // namespace quadrille::sew
