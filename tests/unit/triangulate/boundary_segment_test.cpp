#include "triangulate/boundary_segment.hpp"

#include <gtest/gtest.h>

namespace quadrille::triangulate {
namespace {

Segment straight(Vec2 from, Vec2 to) {
  Segment segment;
  for (int i = 0; i < 5; ++i) segment.samples[i] = from + i / 4.0 * (to - from);
  return segment;
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

}  // namespace
}  // namespace quadrille::triangulate
