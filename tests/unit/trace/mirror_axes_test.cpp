#include "trace/mirror_axes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../support/critical_points.hpp"
#include "../support/square_field.hpp"
#include "trace/line_tracer.hpp"

namespace quadrille::trace {
namespace {

CadFace square() { return square_mesh({-1, -1}, 2, 2).face; }

std::size_t num_axes(const std::vector<CriticalPoint>& nodes) {
  CriticalPoints points;
  points.critical_points = nodes;
  return mirror_axes(square(), points).size();
}

TEST(MirrorAxes, AreThoseOfTheFaceAndItsNodes) {
  using hand_made::node;
  EXPECT_EQ(num_axes({}), 4u);
  EXPECT_EQ(num_axes({node({0, 0}, 5)}), 4u);
  EXPECT_EQ(num_axes({node({0.3, 0}, 5)}), 1u);
  EXPECT_EQ(num_axes({node({0.3, 0.1}, 5), node({0.3, -0.1}, 5)}), 1u);
  EXPECT_EQ(num_axes({node({0.3, 0.1}, 5), node({0.3, -0.1}, 3)}), 0u);
  EXPECT_EQ(num_axes({node({0.3, 0.1}, 5)}), 0u);
}

TEST(MirrorAxes, DoNotExistWhereWindingsArePrescribed) {
  CriticalPoints points;
  points.hole_winding_offsets = {0};
  EXPECT_TRUE(mirror_axes(square(), points).empty());
}

// v = conj z + i bend x^2 has a node with five lines at the centre of the square. One of them starts along the x axis;
// the field's direction at (x, 0) is about bend x / 4.
Streamline line_along_x(double bend, double length = 5) {
  const Field field = interpolated_field(square_mesh({-1, -1}, 2, 5), 2, [&](Vec2 p) {
    return Vec2{p.x, bend * p.x * p.x - p.y};
  });
  const field::FieldEvaluator evaluator(field);
  CriticalPoints points;
  points.critical_points = {{{0, 0}, -1, 5, 0, {}, {}}};
  const std::vector<Vec2> nodes{{0, 0}};
  TraceOptions options;
  options.max_length = 5;
  LineTracer tracer(evaluator, points, nodes, options);
  tracer.follow_all_to(length);
  tracer.follow_all_to(5);
  for (const Streamline& line : tracer.lines())
    if (std::cos(line.launch.angle) > 0.99) return line;
  ADD_FAILURE() << "no line starts along the x axis";
  return {};
}

TEST(MirrorAxes, LinesOnThemAreStraight) {
  const Streamline line = line_along_x(1e-3);
  EXPECT_TRUE(line.launch.is_straight);
  EXPECT_EQ(line.end, Streamline::End::boundary);
  EXPECT_NEAR(line.end_position.x, 1, 1e-12);
  EXPECT_NEAR(line.end_position.y, 0, 1e-12);
}

TEST(MirrorAxes, LinesThatAreContinuedStayStraight) {
  const Streamline line = line_along_x(1e-3, 0.1);
  EXPECT_TRUE(line.launch.is_straight);
  EXPECT_NEAR(line.end_position.y, 0, 1e-12);
}

TEST(MirrorAxes, AFieldThatIsNotSymmetricIsFollowed) {
  const Streamline line = line_along_x(0.2);
  EXPECT_FALSE(line.launch.is_straight);
  EXPECT_GT(std::abs(line.end_position.y), 0.01);
}

}  // namespace
}  // namespace quadrille::trace
