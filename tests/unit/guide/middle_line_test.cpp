#include "guide/middle_line.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../triangulate/faces.hpp"
#include "base/angle.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::guide {
namespace {

using namespace testing_faces;

// Its sharp corner at the origin, the bisector along x.
CadFace needle(const std::vector<Loop>& holes = {}) {
  std::vector<Loop> loops{polygon({{0, 0}, {4, -0.4}, {4, 0.4}})};
  loops.insert(loops.end(), holes.begin(), holes.end());
  return make_face(loops);
}

// Between two arcs of radius 1 that leave the origin at angles of +-0.05 radians and bend to the left.
CadFace hook() {
  const auto centre = [](double angle) { return Vec2{-std::sin(angle), std::cos(angle)}; };
  const Nurbs lower = curve::circular_arc(centre(-0.05), 1, -half_pi - 0.05, -half_pi + 0.75);
  const Nurbs upper = curve::circular_arc(centre(0.05), 1, -half_pi + 0.75, -half_pi + 0.05);
  return make_face({{lower, curve::segment(lower.poles.back(), upper.poles.front()), upper}});
}

TEST(MiddleLine, IsTheBisectorOfStraightSides) {
  const CadFace face = needle();
  const MiddleLine line = middle_line(face, 0);
  EXPECT_NEAR(line.side, std::hypot(4, 0.4), 1e-14);
  EXPECT_NEAR(length_inside(face, line), 4, 1e-9);
  EXPECT_LE(distance(point_at(line, 1.5), {1.5, 0}), 1e-14);
  EXPECT_EQ(length_of_small_turn(line, 1), INFINITY);
}

TEST(MiddleLine, EndsAtAHole) {
  const CadFace face = needle({hole({3, 0}, 0.05)});
  EXPECT_NEAR(length_inside(face, middle_line(face, 0)), 2.95, 1e-9);
}

TEST(MiddleLine, FollowsSidesThatBend) {
  const CadFace face = hook();
  const MiddleLine line = middle_line(face, 0);
  for (std::size_t i = 1; i < line.points.size(); ++i) {
    // The middle line is an arc of radius 1 that leaves the origin along x.
    EXPECT_NEAR(distance(line.points[i], {0, 1}), 1, 2e-3);
    EXPECT_NEAR(line.widths[i], 0.1 * norm(line.points[i]), 2e-3);
  }
  EXPECT_NEAR(length_inside(face, line), 0.7, 0.05);
}

TEST(MiddleLine, ABentWedgeHasLittleOfSmallTurn) {
  // An arc of radius 1 turns by its length; the corner sees the width under 0.1 radians.
  EXPECT_NEAR(length_of_small_turn(middle_line(hook(), 0), 1), 0.1, 0.02);
  EXPECT_NEAR(length_of_small_turn(middle_line(hook(), 0), 3), 0.3, 0.03);
}

}  // namespace
}  // namespace quadrille::guide
