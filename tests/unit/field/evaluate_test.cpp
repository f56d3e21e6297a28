#include "field/evaluate.hpp"

#include <gtest/gtest.h>

#include "../hand_made.hpp"
#include "../support/square_field.hpp"
#include "base/error.hpp"
#include "field/explicit_value.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille::field {
namespace {

constexpr double tol = 1e-13;

Vec2 cubic(Vec2 p) { return {p.x * p.x * p.x - 3 * p.x * p.y * p.y + 0.1, 3 * p.x * p.x * p.y - p.y * p.y * p.y}; }
Mat2 cubic_gradient(Vec2 p) {
  const double re = 3 * (p.x * p.x - p.y * p.y), im = 6 * p.x * p.y;
  return {re, -im, im, re};
}

void expect_near(const Mat2& a, const Mat2& b) {
  EXPECT_NEAR(a.xx, b.xx, 1e-11);
  EXPECT_NEAR(a.xy, b.xy, 1e-11);
  EXPECT_NEAR(a.yx, b.yx, 1e-11);
  EXPECT_NEAR(a.yy, b.yy, 1e-11);
}

TEST(FieldEvaluator, reproduces_a_harmonic_polynomial_and_its_gradient) {
  const Field field = interpolated_field(square_mesh({-1, -1}, 2, 3), 5, cubic);
  const FieldEvaluator evaluator(field);
  for (int e = 0; e < field.mesh.num_elems(); ++e)
    for (const Vec2 xi : {Vec2{-1, -1}, Vec2{-0.2, -0.4}, Vec2{0.5, -0.9}}) {
      const FieldSample s = evaluator.sample(e, xi);
      EXPECT_NEAR(distance(s.x, evaluator.maps()[e].position(xi)), 0, tol);
      EXPECT_NEAR(distance(s.value, cubic(s.x)), 0, tol);
      expect_near(s.dv_dx, cubic_gradient(s.x));
      Vec2 x;
      Mat2 dx_dxi;
      EXPECT_EQ(evaluator.value(e, xi, x, dx_dxi), s.value);
      EXPECT_EQ(x, s.x);
    }
}

TEST(FieldEvaluator, looks_first_where_a_point_near_by_lies) {
  const Field field = interpolated_field(square_mesh({-1, -1}, 2, 3), 5, cubic);
  const FieldEvaluator evaluator(field);
  mesh::Location at;
  for (const Vec2 x : {Vec2{-0.9, -0.8}, Vec2{-0.89, -0.8}, Vec2{0.7, 0.1}, Vec2{0, 0}}) {
    Vec2 value;
    ASSERT_TRUE(evaluator.value_near(x, at, value));
    EXPECT_NEAR(distance(value, cubic(x)), 0, tol);
    EXPECT_NEAR(distance(evaluator.maps()[at.elem].position(at.xi), x), 0, tol);
  }
  const mesh::Location last = at;
  Vec2 value;
  EXPECT_FALSE(evaluator.value_near({2, 0}, at, value));
  EXPECT_EQ(at.elem, last.elem);
}

TEST(FieldEvaluator, adds_liftings_and_their_gradients) {
  Field field = interpolated_field(square_mesh({0, 0}, 1, 2), 4, cubic);
  field.liftings = {{0, {0, 0}, {-0.5, -0.5}, {0.3, -0.7}}, {2, {1, 1}, {1.4, 1.5}, {1, 0.2}}};
  const FieldEvaluator evaluator(field);
  const Vec2 x{0.37, 0.61};
  Vec2 expected = cubic(x);
  for (const Lifting& l : field.liftings) expected += l.jump * lifting_angle(l, x);
  Vec2 value;
  ASSERT_TRUE(evaluator.value_at(x, value));
  EXPECT_NEAR(distance(value, expected), 0, tol);

  const mesh::Location at = evaluator.locator().find(x);
  const double h = 1e-6;
  Vec2 east, west, north, south;
  evaluator.value_at(x + Vec2{h, 0}, east);
  evaluator.value_at(x - Vec2{h, 0}, west);
  evaluator.value_at(x + Vec2{0, h}, north);
  evaluator.value_at(x - Vec2{0, h}, south);
  const Mat2 g = evaluator.sample(at.elem, at.xi).dv_dx;
  EXPECT_NEAR(distance((east - west) / (2 * h), {g.xx, g.yx}), 0, 1e-9);
  EXPECT_NEAR(distance((north - south) / (2 * h), {g.xy, g.yy}), 0, 1e-9);
}

TEST(FieldEvaluator, is_finite_on_a_corner_with_a_lifting) {
  Field field = interpolated_field(square_mesh({0, 0}, 1, 1), 2, [](Vec2) { return Vec2{}; });
  field.liftings = {{0, {0, 0}, {-0.5, -0.5}, {1, 0}}};
  const FieldEvaluator evaluator(field);
  // Element 0 lies below the diagonal, element 1 above: the limits follow the direction from the corner.
  const Vec2 below = evaluator.sample(0, {-1, -1}).value, above = evaluator.sample(1, {-1, -1}).value;
  EXPECT_NEAR(above.x - below.x, std::atan2(2, 1) - std::atan2(1, 2), tol);
}

void expect_equal_values(const Field& field) {
  const FieldEvaluator summed(field), expanded(field, FarTerms::expanded);
  for (int e = 0; e < field.mesh.num_elems(); ++e)
    for (const Vec2 xi : {Vec2{-1, -1}, Vec2{-0.2, -0.4}, Vec2{0.5, -0.9}, Vec2{-1, 1}, Vec2{4, 3}}) {
      Vec2 x;
      Mat2 dx_dxi;
      const Vec2 expected = summed.value(e, xi, x, dx_dxi);
      EXPECT_NEAR(distance(expanded.value(e, xi, x, dx_dxi), expected), 0, 5e-15) << e;
      EXPECT_NEAR(distance(expanded.sample(e, xi).value, expected), 0, 5e-15) << e;
    }
}

// Cuts, from apexes to poles, across elements, far from them, and between both.
TEST(FieldEvaluator, expands_far_liftings) {
  Field field = interpolated_field(square_mesh({0, 0}, 1, 8), 2, cubic);
  field.liftings = {{0, {0, 0}, {-0.5, -0.5}, {0.3, -0.7}},
                    {1, {1, 0}, {1.3, -2}, {-0.4, 0.9}},
                    {2, {1, 1}, {1.4, 1.5}, {1, 0.2}},
                    {3, {-0.2, 0.52}, {1.7, 0.53}, {0.1, 0.5}}};
  expect_equal_values(field);
}

TEST(FieldEvaluator, expands_far_terms_of_a_phase) {
  Field field = interpolated_field(square_mesh({0, 0}, 1, 8), 2, cubic);
  field.kind = FieldKind::phase;
  field.phase.s = field.u;
  field.phase.terms = {{{{0.31, 0.42}, 1}, {{0.8, 0.77}, -1}, {{0.1, 0.9}, 0}},
                       {{{0.52, 0.13}, -3}},
                       {{{1.2, -0.3}, 2}},
                       {{{0, 0}, {-0.5, -0.5}, -2.0 / 3}, {{1, 1}, {1.5, 1.7}, 1.25}}};
  expect_equal_values(field);
}

TEST(FieldEvaluator, says_when_a_point_is_outside) {
  const Field field = interpolated_field(square_mesh({0, 0}, 1, 1), 1, [](Vec2 p) { return p; });
  Vec2 value;
  EXPECT_FALSE(FieldEvaluator(field).value_at({1.5, 0.5}, value));
}

TEST(FieldsOfRegions, rotates_the_cross_of_a_rotated_field) {
  const Field field = interpolated_field(square_mesh({-1, -1}, 2, 3), 5, cubic);
  const FieldEvaluator evaluator(field);
  const curve::Rotation rotation{{0.1, 0.2}, 0.3};
  const FieldsOfRegions rotated({&evaluator}, {rotation});
  const Vec2 x{0.3, -0.2};
  const PointSample sample = rotated.values_at({rotation.of(x)}).front();
  ASSERT_GE(sample.at.elem, 0);
  EXPECT_NEAR(distance(evaluator.maps()[sample.at.elem].position(sample.at.xi), x), 0, tol);
  EXPECT_NEAR(angle_of(sample.value), angle_of(cubic(x)) + 4 * 0.3, tol);
  EXPECT_NEAR(norm(sample.value), norm(cubic(x)), tol);
}

// Points all over the bounding box of a ring: curved elements, a hole, an outside, and jumps from one end to the other.
TEST(FieldEvaluator, meets_single_evaluation_at_many_points_of_a_ring) {
  Report report;
  const CadFace ring = hand_made::face(
      {{curve::circular_arc({0, 0}, 1, 0, 2 * pi)}, {curve::circular_arc({0.1, 0}, 0.4, 0, -2 * pi)}}, 2);
  Field field = interpolated_field(triangulate::triangulate(ring, {}, report), 6, cubic);
  const FieldEvaluator evaluator(field);
  std::vector<Vec2> points;
  for (int i = 0; i < 2000; ++i) points.push_back({std::cos(7.0 * i) * 1.1, std::sin(0.01 * i) * 1.1});
  const std::vector<PointSample> samples = evaluator.values_at(points);
  ASSERT_EQ(samples.size(), points.size());
  int num_inside = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Vec2 value;
    const bool is_inside = evaluator.value_at(points[i], value);
    ASSERT_EQ(samples[i].at.elem >= 0, is_inside) << i;
    if (!is_inside) continue;
    ++num_inside;
    EXPECT_NEAR(distance(samples[i].value, value), 0, 1e-12);
    const FieldSample there = evaluator.sample(samples[i].at.elem, samples[i].at.xi);
    EXPECT_NEAR(distance(there.x, points[i]), 0, 1e-13);
  }
  EXPECT_GT(num_inside, 500);
  EXPECT_LT(num_inside, 1900);
}

// phi = arg(z - a) - arg(z - b) + s, s = 0.3 + 2 x.
Field phase_field(Vec2 a, Vec2 b) {
  Field field = interpolated_field(square_mesh({0, 0}, 1, 2), 2, [](Vec2 x) { return Vec2{0.3 + 2 * x.x, 0}; });
  field.kind = FieldKind::phase;
  field.phase.s = field.u;
  field.u.clear();
  field.v.clear();
  field.phase.prescribed.nodes = {{a, 3}, {b, 5}};
  field.phase.terms.nodes = {{a, 1}, {b, -1}};
  return field;
}

TEST(NodePhase, IsThePhaseWithoutTheNodesOwnTerm) {
  const Vec2 a{0.25, 0.4}, b{0.75, 0.9};
  const Field field = phase_field(a, b);
  const FieldEvaluator evaluator(field);
  EXPECT_NEAR(wrap_pi(node_phase(evaluator, 0) - (0.3 + 2 * a.x - angle_of(a - b))), 0, 1e-13);
  EXPECT_NEAR(wrap_pi(node_phase(evaluator, 1) - (0.3 + 2 * b.x + angle_of(b - a))), 0, 1e-13);
}

TEST(NodePhase, RefusesNodesOutsideTheMesh) {
  const Field field = phase_field({1.5, 0.5}, {0.5, 0.5});
  const FieldEvaluator evaluator(field);
  EXPECT_THROW(node_phase(evaluator, 0), FormatError);
}

}  // namespace
}  // namespace quadrille::field
