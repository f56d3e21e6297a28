#include "spectral/det_sampler.hpp"

#include <gtest/gtest.h>

#include "spectral/quadrature.hpp"

namespace quadrille::spectral {
namespace {

/// The nodes of an element of this order under a map of the reference square or cube.
template <typename Map>
std::vector<Vec2> quad_nodes(int order, const Map& map) {
  std::vector<Vec2> nodes;
  for (const double b : gll_points(order))
    for (const double a : gll_points(order)) nodes.push_back(map(a, b));
  return nodes;
}
template <typename Map>
std::vector<Vec3> hex_nodes(int order, const Map& map) {
  std::vector<Vec3> nodes;
  for (const double c : gll_points(order))
    for (const double b : gll_points(order))
      for (const double a : gll_points(order)) nodes.push_back(map(a, b, c));
  return nodes;
}

TEST(DetSampler, DetJOfAQuadAtTheGridOfPointsTheFirstCoordinateFastest) {
  // x = a + b^2 / 4 + 1e6, y = b + a b / 2: det J = 1 + a / 2 - b^2 / 4
  const auto nodes = quad_nodes(3, [](double a, double b) { return Vec2{1e6 + a + b * b / 4, b + a * b / 2}; });
  const std::vector<double> points{-1, 0.5, 1};
  const std::vector<double> dets = DetSampler(3, points).of_quad(nodes.data());
  ASSERT_EQ(dets.size(), 9U);
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(dets[3 * j + i], 1 + points[i] / 2 - points[j] * points[j] / 4, 1e-8) << i << j;
}

TEST(DetSampler, DetJOfAHexahedron) {
  // (a + b c / 4, b, c (1 + a / 2)): det J = 1 + a / 2 - b c / 8
  const auto nodes = hex_nodes(2, [](double a, double b, double c) { return Vec3{a + b * c / 4, b, c * (1 + a / 2)}; });
  const std::vector<double> points{-1, 0.5};
  const std::vector<double> dets = DetSampler(2, points).of_hex(nodes.data());
  ASSERT_EQ(dets.size(), 8U);
  for (int k = 0; k < 8; ++k) {
    const double a = points[k % 2], b = points[k / 2 % 2], c = points[k / 4];
    EXPECT_NEAR(dets[k], 1 + a / 2 - b * c / 8, 1e-13) << k;
  }
}

}  // namespace
}  // namespace quadrille::spectral
