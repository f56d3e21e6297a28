#include "sew/curve_crossings.hpp"

#include <gtest/gtest.h>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::sew {
namespace {

TEST(CurveCrossings, OfALineAndACircleAreExact) {
  const Nurbs circle = curve::circular_arc({0, 0}, 1, 0, 2 * pi), line = curve::segment({-2, 0.6}, {2, 0.6});
  const auto found = curve_crossings(line, circle, 1e-6, "x");
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(distance(found[0].position, {-0.8, 0.6}), 0, 1e-14);
  EXPECT_NEAR(distance(found[1].position, {0.8, 0.6}), 0, 1e-14);
  EXPECT_NEAR(distance(curve::point(circle, found[1].t_b), {0.8, 0.6}), 0, 1e-14);
}

TEST(CurveCrossings, AtKnotsCountOnce) {
  const Nurbs circle = curve::circular_arc({0, 0}, 1, 0, 2 * pi), line = curve::segment({0, -2}, {0, 2});
  EXPECT_EQ(curve_crossings(line, circle, 1e-6, "x").size(), 2U);
  EXPECT_EQ(curve_crossings(circle, line, 1e-6, "x").size(), 2U);
}

TEST(CurveCrossings, OfDistantOrParallelLinesAreNone) {
  EXPECT_TRUE(curve_crossings(curve::segment({0, 0}, {1, 0}), curve::segment({0, 1}, {1, 1}), 1e-6, "x").empty());
  EXPECT_TRUE(curve_crossings(curve::segment({0, 0}, {1, 0}), curve::segment({2, -1}, {2, 1}), 1e-6, "x").empty());
}

TEST(CurveCrossings, ACurveThatFollowsAnotherOneSmoothlyDoesNotCrossIt) {
  const Nurbs arc = curve::circular_arc({0, 1}, 1, 0, 1.5 * pi), line = curve::segment({0, 0}, {2, 0});
  EXPECT_TRUE(curve_crossings(arc, line, 1e-6, "x").empty());
  EXPECT_THROW(curve_crossings(arc, curve::segment({-1, 0}, {1, 0}), 1e-6, "x"), FormatError) << "not at its end";
}

TEST(CurveCrossings, CurvesAlongEachOtherAreRefused) {
  const Nurbs circle = curve::circular_arc({0, 0}, 1, 0, 2 * pi), arc = curve::circular_arc({0, 0}, 1, 1, 2);
  EXPECT_THROW(curve_crossings(circle, arc, 1e-6, "edges 1 and 2"), FormatError);
  EXPECT_THROW(curve_crossings(circle, curve::segment({-1, 1 - 1e-9}, {1, 1 - 1e-9}), 1e-6, "edges 1 and 2"),
               FormatError);
}

}  // namespace
}  // namespace quadrille::sew
