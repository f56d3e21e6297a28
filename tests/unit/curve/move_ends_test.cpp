#include "curve/move_ends.hpp"

#include <gtest/gtest.h>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::curve {
namespace {

TEST(MoveEnds, ASegmentStaysASegmentWithItsLengthAsParameter) {
  const Nurbs moved = with_ends(segment({0, 0}, {3, 0}), {0, 0}, {3, 4});
  EXPECT_EQ(moved.degree, 1);
  EXPECT_DOUBLE_EQ(moved.end(), 5);
}

TEST(MoveEnds, EqualDisplacementsMoveTheCurveAndNothingElse) {
  const Nurbs arc = circular_arc({1, 2}, 3, 0.1, 1.4);
  const Vec2 way = {0.01, -0.02};
  const Nurbs moved = with_ends(arc, arc.poles.front() + way, arc.poles.back() + way);
  for (const double t : {0.0, 0.3, 0.8, 1.0}) {
    const double u = arc.begin() + t * (arc.end() - arc.begin());
    EXPECT_NEAR(distance(point(moved, u), point(arc, u) + way), 0, 1e-14);
  }
}

TEST(MoveEnds, PolesThatCoincideRemainSoAndTangentsTurnByTheDisplacementOverTheLength) {
  const Nurbs curve{3, {0, 0, 0, 0, 1, 1, 1, 1}, {{0, 0}, {0, 0}, {1, 0}, {2, 0}}, {1, 1, 1, 1}};
  const Nurbs moved = with_ends(curve, {0, 1e-4}, {2, 0});
  EXPECT_EQ(moved.poles[0], (Vec2{0, 1e-4}));
  EXPECT_EQ(moved.poles[1], moved.poles[0]);
  EXPECT_EQ(moved.poles[3], (Vec2{2, 0}));
  EXPECT_NEAR(angle_of(tangent(moved, moved.begin())), -1e-4 / 2, 1e-8);
}

TEST(MoveEnds, AClosedCurveMovesAsAWhole) {
  const Nurbs circle = circular_arc({0, 0}, 1, 0, 2 * pi);
  const Vec2 seam = {1, 1e-3};
  const Nurbs moved = with_ends(circle, seam, seam);
  EXPECT_EQ(moved.poles.front(), seam);
  EXPECT_EQ(moved.poles.back(), seam);
  EXPECT_NEAR(point(moved, (moved.begin() + moved.end()) / 2).x, -1, 1e-12);
}

}  // namespace
}  // namespace quadrille::curve
