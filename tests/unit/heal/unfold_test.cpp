#include "heal/unfold.hpp"

#include <gtest/gtest.h>

#include "curve/nurbs.hpp"
#include "heal/heal_face.hpp"
#include "raw_samples.hpp"

namespace quadrille::heal {
namespace {

// A C1 cubic from (0, 0) to (6, 1). The poles beside its double knot are exchanged if `back` > 0, by that distance.
Nurbs wave(double back) {
  const Vec2 a{3 + back / 2, 0.5}, b{3 - back / 2, 0.5};
  return {3, {0, 0, 0, 0, 1, 1, 2, 2, 2, 2}, {{0, 0}, {1, 0}, a, b, {5, 1}, {6, 1}}, {1, 1, 1, 1, 1, 1}};
}

TEST(Unfold, PutsPolesInOrder) {
  Nurbs curve = wave(1e-4);
  EXPECT_NEAR(unfold(curve, 2e-4), 1e-4, 1e-15);
  EXPECT_EQ(curve.poles, wave(-1e-4).poles);
  EXPECT_EQ(unfold(curve, 2e-4), 0);
}

TEST(Unfold, OneExchangeCanNeedAnother) {
  const std::vector<Vec2> sorted{{0, 0}, {1, 0}, {1.1, 0}, {1.2, 0}, {1.3, 0}, {3, 0}};
  Nurbs curve = wave(0);
  curve.poles = {sorted[0], sorted[2], sorted[3], sorted[4], sorted[1], sorted[5]};
  EXPECT_NEAR(unfold(curve, 0.4), 0.3, 1e-15);
  EXPECT_EQ(curve.poles, sorted);
}

TEST(Unfold, KeepsWhatWouldMoveTooFar) {
  Nurbs curve = wave(1e-4);
  EXPECT_EQ(unfold(curve, 9e-5), 0);
  EXPECT_EQ(curve.poles, wave(1e-4).poles);
}

TEST(Unfold, KeepsCurvesThatTurn) {
  // A leg against one of its neighbours only is a turn: the wire goes on to the other side.
  Nurbs turn = wave(0);
  turn.poles = {{0, 0}, {1, 0}, {1.1, 0}, {1.05, 0.1}, {0, 0.2}, {-1, 0.2}};
  const std::vector<Vec2> old = turn.poles;
  EXPECT_EQ(unfold(turn, 1), 0);
  EXPECT_EQ(turn.poles, old);
}

TEST(Unfold, HealingReportsIt) {
  RawFace raw = raw_face({wave(1e-4), curve::segment({6, 1}, {6, 5}), curve::segment({6, 5}, {0, 0})});
  Report report;
  const auto repairs = heal_face(raw, {1e-4}, 10, report);
  ASSERT_EQ(repairs.size(), 1U);
  EXPECT_EQ(repairs[0].kind, RepairKind::fold);
  EXPECT_NEAR(repairs[0].distance, 1e-4, 1e-15);
  EXPECT_EQ(repairs[0].position, (Vec2{3 + 5e-5, 0.5}));
  EXPECT_TRUE(heal_face(raw, {1e-4}, 10, report).empty());
}

}  // namespace
}  // namespace quadrille::heal
