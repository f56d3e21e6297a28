#include "trace/advance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "../support/square_field.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"
#include "trace/launch_directions.hpp"

namespace quadrille::trace {
namespace {

const PointGrid nodes({{0, 0}, {1, 0}});
constexpr double hit = 1e-3;

TEST(NodeProximity, StepsAreHalfTheDistanceToTheNearestOtherNode) {
  NodeProximity proximity(nodes, nodes.points()[0], true);
  EXPECT_EQ(proximity.move_to({0.2, 0}), 1);
  EXPECT_NEAR(proximity.longest_step(), 0.4, 1e-15);
}

TEST(NodeProximity, WithoutOtherNodesStepsAreNotBounded) {
  const PointGrid one({{0, 0}});
  NodeProximity proximity(one, one.points()[0], true);
  EXPECT_EQ(proximity.move_to({0.2, 0}), -1);
  EXPECT_TRUE(std::isinf(proximity.longest_step()));
}

TEST(NodeProximity, ALineHitsItsOwnNodeOnceItHasLeftIt) {
  NodeProximity proximity(nodes, nodes.points()[0], true);
  EXPECT_EQ(proximity.node_hit_at({0.5 * hit, 0}, hit), -1);
  EXPECT_EQ(proximity.node_hit_at({11 * hit, 0}, hit), -1);
  EXPECT_EQ(proximity.node_hit_at({0.5 * hit, 0}, hit), 0);
}

TEST(NodeProximity, AnotherNodeIsHitWithinTheDistance) {
  NodeProximity proximity(nodes, nodes.points()[0], true);
  EXPECT_EQ(proximity.node_hit_at({1 - 1.1 * hit, 0}, hit), -1);
  EXPECT_EQ(proximity.node_hit_at({1 - 0.9 * hit, 0}, hit), 1);
}

using Complex = std::complex<double>;

Vec2 vec(Complex z) { return {z.real(), z.imag()}; }
Complex complex(Vec2 p) { return {p.x, p.y}; }

AdvanceOptions options() { return {1e-11, 0.1, 20, 1e-7}; }

// From a point inside, without a node.
Launch launch_at(const field::FieldEvaluator& evaluator, Vec2 x, double angle) {
  const mesh::Location at = evaluator.locator().find(x);
  return {{}, x, angle, 0, at.elem, at.xi, x, angle};
}

// Where a ray from 0 leaves the square [-1, 1]^2.
Vec2 on_square(double angle) {
  const Vec2 d = unit(angle);
  return d / std::max(std::abs(d.x), std::abs(d.y));
}

void expect_straight_rays(const Mat2& j) {
  const Field field = interpolated_field(square_mesh({-1, -1}, 2, 5), 1, [&](Vec2 p) { return j * p; });
  const field::FieldEvaluator evaluator(field);
  for (const double angle : launch_directions(j)) {
    const Launch launch = launch_line(evaluator, 0, {0, 0}, angle, 1e-4, 1);
    const Streamline line = advance(evaluator, launch, PointGrid({{0, 0}}), options());
    ASSERT_EQ(line.end, Streamline::End::boundary);
    EXPECT_LT(distance(line.end_position, on_square(angle)), 1e-9);
    EXPECT_NEAR(line.length(), norm(on_square(angle)), 1e-9);
    EXPECT_EQ(line.at(evaluator, 0), (Vec2{0, 0}));
    // The end lies on the curve exactly, at the parameter it names.
    EXPECT_EQ(line.end_position, curve::point(field.mesh.face.curves[line.reached.curve], line.reached.t));
  }
}

TEST(Advance, ThreeStraightRaysAtZ) { expect_straight_rays({1, 0, 0, 1}); }
TEST(Advance, FiveStraightRaysAtConjugateZ) { expect_straight_rays({1, 0, 0, -1}); }

TEST(Advance, StaysOnACircleOverManyElements) {
  const Field field =
      interpolated_field(square_mesh({-1, -1}, 2, 6), 4, [](Vec2 p) { return vec(std::pow(complex(p), 4)); });
  const field::FieldEvaluator evaluator(field);
  AdvanceOptions bounds = options();
  bounds.max_length = 2 * pi * 0.7;
  const Streamline line = advance(evaluator, launch_at(evaluator, {0.7, 0}, half_pi), PointGrid({}), bounds);
  ASSERT_EQ(line.end, Streamline::End::length);
  for (int i = 0; i <= 100; ++i) {
    const double s = 2 * pi * 0.7 * i / 100;
    Vec2 direction;
    const Vec2 x = line.at(evaluator, s, direction);
    EXPECT_LT(distance(x, 0.7 * unit(s / 0.7)), 1e-8) << s;
    EXPECT_LT(distance(direction, unit(s / 0.7 + half_pi)), 1e-5) << s;
  }
}

TEST(Advance, RunsAlongElementEdgesAndThroughVertices) {
  const Field field = interpolated_field(square_mesh({-1, -1}, 2, 4), 1, [](Vec2) { return Vec2{1, 0}; });
  const field::FieldEvaluator evaluator(field);
  for (const double y : {0.0, 0.25, 0.5}) {
    const Streamline line = advance(evaluator, launch_at(evaluator, {-0.9, y}, 0), PointGrid({}), options());
    ASSERT_EQ(line.end, Streamline::End::boundary);
    EXPECT_LT(distance(line.end_position, {1, y}), 1e-12);
  }
  // A cross turned by 45 degrees: along the diagonals of the mesh, through its vertices.
  const Field turned = interpolated_field(square_mesh({-1, -1}, 2, 4), 1, [](Vec2) { return Vec2{-1, 0}; });
  const field::FieldEvaluator diagonal(turned);
  const Streamline line = advance(diagonal, launch_at(diagonal, {-0.9, -0.9}, pi / 4), PointGrid({}), options());
  ASSERT_EQ(line.end, Streamline::End::boundary);
  EXPECT_LT(distance(line.end_position, {1, 1}), 1e-11);
}

TEST(Advance, EndsInANodeThatItMeets) {
  // v = -(z^2 - 1/4): the separatrices of two nodes of valence 3 run into each other along the axis.
  const Field field =
      interpolated_field(square_mesh({-1, -1}, 2, 5), 2, [](Vec2 p) { return vec(0.25 - complex(p) * complex(p)); });
  const field::FieldEvaluator evaluator(field);
  const std::vector<Vec2> ends{{-0.5, 0}, {0.5, 0}};
  const Launch launch = launch_line(evaluator, 0, ends[0], 0, 1e-4, 1);
  const Streamline line = advance(evaluator, launch, PointGrid(ends), options());
  ASSERT_EQ(line.end, Streamline::End::node);
  EXPECT_EQ(line.reached.node, 1);
  EXPECT_EQ(line.end_position, ends[1]);
  EXPECT_NEAR(line.length(), 1, 2e-7);
}

TEST(Advance, EndsOnACurvedLineOnlyAtTheBoundary) {
  // A quarter circle about the square's corner ends on the next side at the same distance.
  const Field field =
      interpolated_field(square_mesh({0, 0}, 1, 4), 4, [](Vec2 p) { return vec(std::pow(complex(p), 4)); });
  const field::FieldEvaluator evaluator(field);
  const Launch launch = launch_from_boundary(evaluator, 0, 0.6);
  EXPECT_EQ(launch.x, (Vec2{0.6, 0}));
  EXPECT_NEAR(launch.angle, half_pi, 1e-15);
  const Streamline line = advance(evaluator, launch, PointGrid({}), options());
  ASSERT_EQ(line.end, Streamline::End::boundary);
  EXPECT_EQ(line.reached.curve, 3);
  EXPECT_LT(distance(line.end_position, {0, 0.6}), 1e-9);
  EXPECT_NEAR(wrap_pi(line.end_angle - pi), 0, 1e-9);
}

TEST(Advance, GoesOnAsIfItHadNeverStopped) {
  const Field field =
      interpolated_field(square_mesh({0, 0}, 1, 4), 4, [](Vec2 p) { return vec(std::pow(complex(p), 4)); });
  const field::FieldEvaluator evaluator(field);
  const Launch launch = launch_from_boundary(evaluator, 0, 0.6);
  const Streamline whole = advance(evaluator, launch, PointGrid({}), options());
  AdvanceOptions bounds = options();
  bounds.max_length = 0.2;
  Streamline line = advance(evaluator, launch, PointGrid({}), bounds);
  for (int i = 0; i < 3; ++i) {
    ASSERT_EQ(line.end, Streamline::End::length) << i;
    bounds.max_length += 0.3;
    follow(evaluator, line, PointGrid({}), bounds);
  }
  ASSERT_EQ(line.end, Streamline::End::boundary);
  EXPECT_EQ(line.end_position, whole.end_position);
  EXPECT_EQ(line.step_ends(), whole.step_ends());
  follow(evaluator, line, PointGrid({}), bounds);  // an end is an end
  EXPECT_EQ(line.step_ends(), whole.step_ends());
}

TEST(Advance, TheNumberOfStepsIsBounded) {
  const Field field = interpolated_field(square_mesh({-1, -1}, 2, 2), 1, [](Vec2) { return Vec2{1, 0}; });
  const field::FieldEvaluator evaluator(field);
  AdvanceOptions bounds = options();
  bounds.max_step = 1e-6;
  const Streamline line = advance(evaluator, launch_at(evaluator, {-0.9, 0.1}, 0), PointGrid({}), bounds);
  EXPECT_EQ(line.end, Streamline::End::length);
  EXPECT_EQ(static_cast<int>(line.steps.size()), max_stream_steps);
}

TEST(Advance, GivesUpWhereTheFieldHasNoDirection) {
  const Field field = interpolated_field(square_mesh({-1, -1}, 2, 3), 1, [](Vec2) { return Vec2{0, 0}; });
  const field::FieldEvaluator evaluator(field);
  EXPECT_THROW(advance(evaluator, launch_at(evaluator, {0.1, 0.2}, 0), PointGrid({}), options()), ComputeError);
}

}  // namespace
}  // namespace quadrille::trace
