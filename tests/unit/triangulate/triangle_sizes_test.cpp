#include "triangulate/triangle_sizes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace quadrille::triangulate {
namespace {

Segment straight(Vec2 a, Vec2 b) {
  Segment s;
  s.s1 = distance(a, b);
  for (int k = 0; k < 5; ++k) s.samples[k] = a + (k / 4.0) * (b - a);
  return s;
}

TEST(BoundarySegment, DistanceIsThatOfThePolygons) {
  EXPECT_EQ(segment_distance(straight({0, 0}, {4, 0}), straight({0, 2}, {4, 3})), 2);
  EXPECT_EQ(segment_distance(straight({0, 0}, {4, 0}), straight({7, 4}, {9, 4})), 5);
  EXPECT_EQ(segment_distance(straight({0, 0}, {4, 0}), straight({2.5, -1}, {2.5, 2})), 0);
}

TEST(BoundarySegment, DistanceSeesABulge) {
  Segment bulged = straight({0, 2}, {4, 2});
  bulged.samples[2].y = 0.5;
  EXPECT_EQ(segment_distance(straight({0, 0}, {4, 0}), bulged), 0.5);
}

TEST(BoundarySegment, IsARimOrAPartOfACurve) {
  Segment segment;
  EXPECT_TRUE(segment.is_rim());
  segment.curve = 2;
  segment.s0 = 1, segment.s1 = 4;
  EXPECT_FALSE(segment.is_rim());
  EXPECT_EQ(segment.length(), 3);
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

TEST(TriangleSizes, TheTreeFindsTheLeastOfAllSegments) {
  std::vector<Segment> segments;
  for (int i = 0; i < 300; ++i) {
    const Vec2 a{std::sin(3.7 * i), std::sin(1.3 * i * i)};
    segments.push_back(straight(a, a + (0.001 + 0.1 * std::abs(std::sin(5.1 * i))) * Vec2{std::cos(i), std::sin(i)}));
  }
  const double growth = 0.2;
  const TriangleSizes sizes(segments, 5, growth);
  for (int i = 0; i < 200; ++i) {
    const Vec2 x{1.5 * std::sin(2.9 * i), 1.5 * std::cos(7.3 * i)};
    double least = 5;
    for (const Segment& segment : segments)
      for (const int k : {0, 2, 4})
        least = std::min(least, segment.length() + growth * distance(x, segment.samples[k]));
    EXPECT_EQ(sizes.at(x), least);
  }
}

}  // namespace
}  // namespace quadrille::triangulate
