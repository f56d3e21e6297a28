#include "triangulate/triangle_sizes.hpp"

#include <gtest/gtest.h>

namespace quadrille::triangulate {
namespace {

Segment straight(Vec2 a, Vec2 b) {
  Segment s;
  s.s1 = distance(a, b);
  for (int k = 0; k < 5; ++k) s.samples[k] = a + (k / 4.0) * (b - a);
  return s;
}

TEST(TriangleSizes, IsTheLengthOnASegmentAndGrowsFromThereUpToTheGlobalSize) {
  const TriangleSizes sizes({straight({0, 0}, {0.1, 0}), straight({0.1, 0}, {1.1, 0})}, 1.5, 0.5);
  EXPECT_NEAR(sizes.at({0.05, 0}), 0.1, 1e-15);
  EXPECT_NEAR(sizes.at({0.1, 1}), 0.1 + 0.5, 1e-15);
  EXPECT_EQ(sizes.at({0, 100}), 1.5);
}

TEST(TriangleSizes, IsLipschitz) {
  const TriangleSizes sizes({straight({0, 0}, {0.01, 0}), straight({2, 1}, {2.5, 1})}, 3, 0.3);
  for (int i = 0; i < 50; ++i) {
    const Vec2 a{-1 + 0.1 * i, 0.05 * i}, b{a.x + 0.03, a.y - 0.04};
    EXPECT_LE(std::abs(sizes.at(a) - sizes.at(b)), 0.3 * 0.05 + 1e-15);
  }
}

}  // namespace
}  // namespace quadrille::triangulate
