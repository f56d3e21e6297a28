#include "stiffness/harmonic_frame.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "base/angle.hpp"

namespace quadrille::stiffness {
namespace {

spectral::TriMap triangle(Vec2 a, Vec2 b, Vec2 c) { return spectral::TriMap(std::array{a, b, c}); }

/// The equilateral triangle about a point.
spectral::TriMap equilateral_at(Vec2 centre, double radius, double turn) {
  return triangle(centre + radius * unit(turn), centre + radius * unit(turn + 2 * pi / 3),
                  centre + radius * unit(turn + 4 * pi / 3));
}

TEST(HarmonicFrame, AnEquilateralTriangleIsItsOwn) {
  for (const double turn : {0.0, 1.0, 4.0}) {
    const HarmonicFrame frame(equilateral_at({5, 7}, 0.25, turn));
    EXPECT_LT(distance(frame.centre, {5, 7}), 1e-14);
    EXPECT_LT(std::abs(frame.b), 1e-14);
    EXPECT_NEAR(frame.slenderness(), 1, 1e-14);
    EXPECT_NEAR(std::abs(frame(Vec2{5, 7} + 0.25 * unit(turn))), 1 / 0.7303, 1e-12) << "whatever the size";
    EXPECT_NEAR(std::arg(frame(Vec2{5, 7} + 0.25 * unit(turn))), 0, 1e-13) << "the first vertex is on the real axis";
  }
}

/// Stretched twice along an axis.
TEST(HarmonicFrame, SlendernessIsTheRatioOfTheSingularValues) {
  const auto stretched = [](double factor) {
    const auto at = [&](double angle) { return Vec2{factor * std::cos(angle), std::sin(angle)}; };
    return HarmonicFrame(triangle(at(0.3), at(0.3 + 2 * pi / 3), at(0.3 + 4 * pi / 3))).slenderness();
  };
  EXPECT_NEAR(stretched(2), 2, 1e-13);
  EXPECT_NEAR(stretched(0.1), 10, 1e-12);
}

TEST(HarmonicFrame, DoesNotDependOnUnitPlaceAndTurn) {
  const HarmonicFrame one(triangle({0, 0}, {1, 0}, {0.2, 0.7}));
  const auto moved = [](Vec2 x) { return Vec2{3, -2} + 100 * (x.x * unit(1) + x.y * left_of(unit(1))); };
  const HarmonicFrame other(triangle(moved({0, 0}), moved({1, 0}), moved({0.2, 0.7})));
  EXPECT_NEAR(std::abs(other.b), std::abs(one.b), 1e-13);
  for (const Vec2 x : {Vec2{0.3, 0.1}, Vec2{0.9, 0.05}}) EXPECT_LT(std::abs(other(moved(x)) - one(x)), 1e-12);
}

/// Polynomials on the boundary of the triangle stay near one, as powers of z do not.
TEST(NextPolynomial, PolynomialsAreOfOneSize) {
  const HarmonicFrame frame(equilateral_at({0, 0}, 1, 0));
  double greatest = 0, least = 1e300;
  for (int i = 0; i < 30; ++i) {
    const Vec2 x = (1 - i / 30.0) * unit(0) + i / 30.0 * unit(2 * pi / 3);
    std::complex<double> p1 = 0, p = 1, p2 = 0, z = frame(x);
    for (int k = 0; k < 26; ++k) {
      const std::complex<double> next = next_polynomial(z, frame.b, p, p1, p2);
      p2 = p1, p1 = p, p = next;
    }
    greatest = std::max(greatest, std::abs(p)), least = std::min(least, std::abs(p));
  }
  EXPECT_LT(greatest, 30);
  EXPECT_GT(greatest, 0.1);
  EXPECT_GT(least, 1e-3);
}

TEST(Equilateral, EnergiesOfModesArePositive) {
  for (const int order : {1, 2, 8}) {
    const Equilateral& of = equilateral(order);
    EXPECT_EQ(of.root_diagonal.size(), 3 * order);
    EXPECT_GT(of.root_diagonal.minCoeff(), 0);
    EXPECT_EQ(of.extension.rows(), (order + 1) * (order + 2) / 2);
    EXPECT_EQ(of.extension.cols(), 3 * order);
  }
  // Cotangents of 60 degrees: each vertex has the energy 1 / sqrt 3.
  EXPECT_NEAR(equilateral(1).root_diagonal[0], std::pow(3, -0.25), 1e-14);
}

}  // namespace
}  // namespace quadrille::stiffness
