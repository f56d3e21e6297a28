#include "trace/line_tracer.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../support/critical_points.hpp"
#include "../support/square_field.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "trace/launch.hpp"

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

// v = conj z: five straight rays from the centre of a square.
struct FiveRays : testing::Test {
  FiveRays() {
    points.critical_points.push_back({{0, 0}, -1, 5, 0, {}, {}});
    options.max_length = 5;
  }
  Field field = interpolated_field(square_mesh({-1, -1}, 2, 5), 1, [](Vec2 p) { return Vec2{p.x, -p.y}; });
  field::FieldEvaluator evaluator{field};
  CriticalPoints points;
  const std::vector<Vec2> nodes{{0, 0}};
  TraceOptions options;
};

TEST_F(FiveRays, LinesAreFollowedInRounds) {
  LineTracer tracer(evaluator, points, nodes, options);
  tracer.follow_all_to(0.3);
  ASSERT_EQ(tracer.lines().size(), 5u);
  EXPECT_EQ(tracer.reaches(), std::vector(5, 0.3));
  for (const Streamline& line : tracer.lines()) EXPECT_TRUE(line.is_endless());
  tracer.follow_to(2, 10);
  EXPECT_FALSE(tracer.lines()[2].is_endless());
  EXPECT_TRUE(tracer.lines()[1].is_endless());
  EXPECT_EQ(tracer.reaches(), (std::vector{0.3, 0.3, 10.0, 0.3, 0.3}));
  tracer.follow_all_to(1e9);
  EXPECT_EQ(tracer.reaches(), std::vector(5, 0.));
  for (const Streamline& line : tracer.lines()) EXPECT_EQ(line.end, Streamline::End::boundary);
}

TEST_F(FiveRays, ACutStartsOnTheBoundary) {
  LineTracer tracer(evaluator, points, nodes, options);
  tracer.follow_all_to(10);
  tracer.add_cut(0, 0.3, 10);
  ASSERT_EQ(tracer.lines().size(), 6u);
  EXPECT_EQ(tracer.lines()[5].launch.start.node, -1);
  EXPECT_EQ(tracer.lines()[5].launch.start.curve, 0);
}

TEST_F(FiveRays, ALineFromAPointIsNotAmongTheLines) {
  LineTracer tracer(evaluator, points, nodes, options);
  tracer.follow_all_to(10);
  EXPECT_EQ(tracer.follow_from({0.5, 0}, 0).end, Streamline::End::boundary);
  EXPECT_EQ(tracer.lines().size(), 5u);
}

// Few lines are counted as 100: a bound of 1 allows 100 steps.
TEST_F(FiveRays, TheNumberOfStepsIsBounded) {
  options.max_steps = 1;
  options.step = 0.1;
  LineTracer tracer(evaluator, points, nodes, options);
  tracer.follow_all_to(0.5);
  EXPECT_GE(tracer.num_steps(), 5u * 5);
  EXPECT_LE(tracer.num_steps(), 100u);
  options.step = 0.01;
  LineTracer fine(evaluator, points, nodes, options);
  EXPECT_THROW(fine.follow_all_to(0.5), ComputeError);
  LineTracer single(evaluator, points, nodes, options);
  single.follow_all_to(0.1);
  EXPECT_THROW(single.follow_to(0, 0.8), ComputeError);
  LineTracer cut(evaluator, points, nodes, options);
  cut.follow_all_to(0.15);
  EXPECT_THROW(cut.add_cut(0, 0.3, 10), ComputeError);
}

}  // namespace
}  // namespace quadrille::trace
