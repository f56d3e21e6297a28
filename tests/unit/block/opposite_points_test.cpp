#include "block/opposite_points.hpp"

#include <gtest/gtest.h>

#include "curve/nurbs.hpp"

namespace quadrille::block {
namespace {

/// Of a line from (0, 0) to (10, 0), walked backwards, and another one, at their middles.
std::optional<double> difference(Vec2 from, Vec2 to) {
  CadFace face;
  face.curves = {curve::segment({10, 0}, {0, 0}), curve::segment(from, to)};
  const std::vector<Nurbs> none;
  const curve::CurveTable table(face, none);
  const curve::Chain a(table, {{0, 0, 10}}), b(table, {{1, face.curves[1].begin(), face.curves[1].end()}});
  return opposite_point_offset({&a, true}, {&b, false}, 0.5);
}

TEST(OppositePoints, IsZeroWhereMiddlesFaceEachOther) {
  ASSERT_TRUE(difference({2, 1}, {8, 1}));
  EXPECT_NEAR(*difference({2, 1}, {8, 1}), 0, 1e-15);
}

TEST(OppositePoints, FollowsAShift) {
  // 10 (1/2 - d/2) = 2 + 10 (1/2 + d/2)
  ASSERT_TRUE(difference({2, 1}, {12, 1}));
  EXPECT_NEAR(*difference({2, 1}, {12, 1}), -0.2, 1e-12);
  EXPECT_NEAR(*difference({-2, 1}, {8, 1}), 0.2, 1e-12);
}

TEST(OppositePoints, FindsNothingWhereTheEndsDoNotReach) { EXPECT_FALSE(difference({11, 1}, {21, 1})); }

}  // namespace
}  // namespace quadrille::block
