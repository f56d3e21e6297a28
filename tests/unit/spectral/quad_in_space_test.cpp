#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/angle.hpp"
#include "quad_samples.hpp"
#include "spectral/quad_map.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::spectral {

namespace {

Vec2 ring(double a, double b) { return (1.5 + b / 2) * unit(pi / 4 * (1 - a)); }
Vec2 wavy(double a, double b) { return {a + 0.2 * std::sin(2 * b + a), b + 0.2 * std::cos(3 * a - b)}; }

/// The part of a cylinder of radius 1 over angles and heights.
std::vector<Vec3> rolled(int order, const Map& map) {
  std::vector<Vec3> nodes;
  for (const Vec2 x : sampled(order, map)) nodes.push_back({std::cos(x.x), std::sin(x.x), x.y});
  return nodes;
}

TEST(QuadInSpace, APlanarElementHasTheBoundsOfThePlane) {
  for (const Map& map : {Map(ring), Map(wavy)}) {
    const auto nodes = sampled(5, map);
    std::vector<Vec3> turned;  // an orthonormal frame
    for (const Vec2 x : nodes) turned.push_back(x.x * Vec3{0.6, 0, 0.8} + x.y * Vec3{0, 1, 0} + Vec3{1, 2, 3});
    EXPECT_NEAR(quad_normal_lower_bound(5, turned.data()), quad_jacobian_lower_bound(5, nodes.data()), 1e-8);
    const ScaledJacobianMinimum a = quad_scaled_jacobian_minimum(5, turned.data()),
                                b = quad_scaled_jacobian_minimum(5, nodes.data());
    EXPECT_NEAR(a.value, b.value, 1e-12);
  }
}

TEST(QuadInSpace, ElementsAreProvedUntilTheyTurnByMoreThanARightAngle) {
  const auto patch = [](double half) { return [half](double a, double b) { return Vec2{half * a, 0.3 * b}; }; };
  // f = 0.3 half cos(angle from the centre), but for interpolation.
  EXPECT_NEAR(quad_normal_lower_bound(8, rolled(8, patch(1)).data()), 0.3 * std::cos(1.0), 1e-5);
  EXPECT_GT(quad_normal_lower_bound(8, rolled(8, patch(1.5)).data()), 0);
  EXPECT_LE(quad_normal_lower_bound(8, rolled(8, patch(1.6)).data()), 0);
  EXPECT_NEAR(quad_scaled_jacobian_minimum(8, rolled(8, patch(1)).data()).value, 1, 1e-4);
  EXPECT_EQ(quad_scaled_jacobian_minimum(8, rolled(8, patch(1.6)).data()).value, -1);
}

TEST(QuadInSpace, FoldedAndCollapsedElementsAreNotProved) {
  const auto folded = rolled(3, [](double a, double b) { return Vec2{0.3 * (a - a * a), 0.3 * b}; });
  EXPECT_LE(quad_normal_lower_bound(3, folded.data()), 0);
  const std::vector<Vec3> point(16, Vec3{1, 2, 3});
  EXPECT_LE(quad_normal_lower_bound(3, point.data()), 0);
  EXPECT_EQ(quad_scaled_jacobian_minimum(3, point.data()).value, -1);
}

TEST(QuadInSpace, BoundsGrowWithTheSquareOfTheUnitAndIgnoreTheOrigin) {
  std::vector<Vec3> nodes = rolled(5, [](double a, double b) { return Vec2{0.8 * a, 0.3 * b}; }), moved;
  for (const Vec3 x : nodes) moved.push_back(1000 * x + Vec3{3e4, -1e4, 5e3});
  const double bound = quad_normal_lower_bound(5, nodes.data());
  EXPECT_NEAR(quad_normal_lower_bound(5, moved.data()), 1e6 * bound, 1e-4 * bound * 1e6);
}

/// Turned over, the normal is the opposite one: an element in space has no side.
TEST(QuadInSpace, HasNoWrongSide) {
  const auto patch = [](double a, double b) { return Vec2{0.8 * a, 0.3 * b}; };
  const std::vector<Vec3> nodes = rolled(4, patch),
                          mirrored = rolled(4, [&](double a, double b) { return patch(-a, b); });
  EXPECT_NEAR(quad_normal_lower_bound(4, mirrored.data()), quad_normal_lower_bound(4, nodes.data()), 1e-12);
}

/// Lengths and angles in the plane are those of the element if it is flat.
TEST(QuadInSpace, TheProjectionOfAFlatElementIsCongruent) {
  std::vector<Vec3> nodes;
  for (const Vec2 x : sampled(3, wavy)) nodes.push_back(x.x * Vec3{0, 0.6, 0.8} + x.y * Vec3{1, 0, 0});
  const std::vector<Vec2> flat = quad_projection(3, nodes.data());
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    EXPECT_NEAR(norm(flat[k]), distance(nodes[k], nodes[0]), 1e-14);
    EXPECT_NEAR(distance(flat[k], flat[15]), distance(nodes[k], nodes[15]), 1e-14);
  }
}

}  // namespace

}  // namespace quadrille::spectral
