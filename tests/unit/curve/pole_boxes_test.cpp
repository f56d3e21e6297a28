#include "curve/pole_boxes.hpp"

#include <gtest/gtest.h>

#include "../triangulate/faces.hpp"
#include "curve/project.hpp"

namespace quadrille::curve {
namespace {

TEST(PoleBoxes, BoundDistancesFromBelow) {
  const std::vector<Nurbs> curves{testing_faces::circle({3, 1}, 0.5)[0], testing_faces::circle({-1, 4}, 1)[0]};
  const PoleBoxes boxes(curves);
  for (const Vec2 x : {Vec2{0, 0}, Vec2{5, 1}, Vec2{3, 1}, Vec2{-1, -2}}) {
    for (int c = 0; c < 2; ++c) EXPECT_LE(boxes.distance_bound(c, x), project(curves[c], x).distance) << c;
  }
  EXPECT_EQ(boxes.distance_bound(0, {5, 1}), 1.5);
}

}  // namespace
}  // namespace quadrille::curve
