#include "outline/polyline_joints.hpp"

#include <gtest/gtest.h>

#include "../triangulate/faces.hpp"

namespace quadrille::outline {
namespace {

using namespace testing_faces;

/// A square of side 10 with a regular polygon of `sides` sides as a hole; `radius` of its corners.
CadFace with_hole(int sides, double radius) {
  std::vector<Vec2> hole;
  for (int k = 0; k < sides; ++k) hole.push_back(Vec2{5, 5} + radius * unit(-2 * pi * k / sides));
  return make_face({polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}}), polygon(hole)});
}

int num_corners(const CadFace& face) {
  return static_cast<int>(
      std::count_if(face.joints.begin(), face.joints.end(), [](const Joint& joint) { return joint.is_corner; }));
}

TEST(SmoothPolylines, small_kinks_of_a_closed_polyline_are_no_corners) {
  CadFace face = with_hole(12, 0.4);  // sides of 0.2, the fiftieth of the diameter is 0.28
  EXPECT_EQ(smooth_polylines(face, radians(43), 1), 12);
  EXPECT_EQ(num_corners(face), 4);
}

TEST(SmoothPolylines, few_kinks_stay_corners) {
  CadFace face = with_hole(12, 0.4);
  EXPECT_EQ(smooth_polylines(face, radians(43), 13), 0);
  EXPECT_EQ(num_corners(face), 16);
  EXPECT_EQ(smooth_polylines(face, radians(43), 12), 12);
}

TEST(SmoothPolylines, kinks_above_the_angle_and_long_edges_stay) {
  CadFace eight = with_hole(8, 0.3);  // 45 degrees
  EXPECT_EQ(smooth_polylines(eight, radians(43), 1), 0);
  CadFace long_edges = with_hole(12, 1);
  EXPECT_EQ(smooth_polylines(long_edges, radians(43), 1), 0);
  CadFace none = with_hole(12, 0.4);
  EXPECT_EQ(smooth_polylines(none, 0, 1), 0);
}

/// A square of side 10 whose lower side begins with `num` short edges that go up and down by 17 degrees.
CadFace with_coast(int num) {
  std::vector<Vec2> points;
  for (int k = 0; k <= num; ++k) points.push_back({2 + 0.1 * k, k % 2 == 0 ? 0 : 0.03});
  points.insert(points.begin(), {0, 0});
  for (const Vec2 corner : {Vec2{10, 0}, Vec2{10, 10}, Vec2{0, 10}}) points.push_back(corner);
  return make_face({polygon(points)});
}

TEST(SmoothPolylines, the_ends_of_an_open_polyline_stay_corners) {
  CadFace face = with_coast(8);
  EXPECT_EQ(smooth_polylines(face, radians(43), 1), 7);
  EXPECT_EQ(num_corners(face), 6);  // those of the square, and both ends
}

TEST(SmoothPolylines, seven_short_edges_are_no_polyline) {
  CadFace face = with_coast(7);
  EXPECT_EQ(smooth_polylines(face, radians(43), 1), 0);
}

}  // namespace
}  // namespace quadrille::outline
