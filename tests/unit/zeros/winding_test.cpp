#include "zeros/winding.hpp"

#include <gtest/gtest.h>

#include <complex>

#include "../support/square_field.hpp"

namespace quadrille::zeros {
namespace {

using Complex = std::complex<double>;

/// z^n, its conjugate for n < 0, on [-1, 1]^2.
Field power(int n) {
  return interpolated_field(square_mesh({-1, -1}, 2, 2), 4, [n](Vec2 x) {
    const Complex w = std::pow(Complex(x.x, x.y), std::abs(n));
    return Vec2{w.real(), n < 0 ? -w.imag() : w.imag()};
  });
}

TEST(CircleIndex, CountsTheZerosInside) {
  for (const int n : {-3, -1, 0, 1, 2, 4}) {
    const Field field = power(n);
    double least = 0;
    EXPECT_EQ(circle_index(field::FieldEvaluator(field), {0, 0}, 0.5, least), n);
    EXPECT_NEAR(least, std::pow(0.5, std::abs(n)), 1e-9);
  }
  const Field field = power(2);
  double least = 0;
  EXPECT_EQ(circle_index(field::FieldEvaluator(field), {0.5, 0.2}, 0.3, least), 0);
}

TEST(CircleIndex, IsNoneWhereTheCircleLeavesTheMesh) {
  const Field field = power(1);
  double least = 0;
  EXPECT_FALSE(circle_index(field::FieldEvaluator(field), {0.8, 0}, 0.3, least).has_value());
}

TEST(PhaseTurn, IsSignedAndFollowsManyTurns) {
  const Field field = power(4);
  const field::FieldEvaluator evaluator(field);
  const auto quarter = phase_turn(evaluator, {0, 0}, 0.5, 0, half_pi);
  ASSERT_TRUE(quarter.has_value());
  EXPECT_NEAR(quarter->turn, 2 * pi, 1e-9);
  const Field conjugate = power(-1);
  EXPECT_NEAR(phase_turn(field::FieldEvaluator(conjugate), {0, 0}, 0.5, 0, 1)->turn, -1, 1e-9);
}

TEST(PhaseTurn, LeavesOutTheEndsOutsideTheMesh) {
  // A quarter circle about a corner of the square, with a margin beyond both sides.
  const Field field = power(1);
  const auto turn = phase_turn(field::FieldEvaluator(field), {-1, -1}, 0.5, -0.1, half_pi + 0.1);
  ASSERT_TRUE(turn.has_value());
  EXPECT_GE(turn->angle0, -1e-6);
  EXPECT_LT(turn->angle0, 0.02);
  EXPECT_LE(turn->angle1, half_pi + 1e-6);
  EXPECT_FALSE(phase_turn(field::FieldEvaluator(field), {3, 0}, 0.5, 0, 1).has_value());
}

}  // namespace
}  // namespace quadrille::zeros
