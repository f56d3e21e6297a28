#include <gtest/gtest.h>

#include <cmath>

#include "../support/polygon_field.hpp"
#include "base/angle.hpp"
#include "field/boundary_values.hpp"
#include "field/evaluate.hpp"
#include "field/explicit_value.hpp"
#include "galerkin/solve_phase.hpp"

namespace quadrille::galerkin {
namespace {

CadFace plate() { return polygon_face({{0, 0}, {4, 0}, {4, 2}, {3, 3}, {0, 3}}); }

/// With enough rings about the corners for data that jump there by a lifting.
Field solved_field(const CadFace& face) {
  Report report;
  triangulate::TriangulateOptions options;
  options.fan_layers = 5;
  const TriMesh mesh = triangulate::triangulate(face, options, report);
  return solve_laplace(mesh, std::vector<int>(mesh.num_elems(), 8), report);
}

std::vector<field::HarmonicPart> parts_of(const Field& field, const std::vector<field::LiftedData>& data) {
  return PhaseSolver(field.mesh, field.elem_order).harmonic_parts(data);
}

Vec2 value_at(const Field& field, Vec2 x) {
  Vec2 value;
  EXPECT_TRUE(field::FieldEvaluator(field).value_at(x, value));
  return value;
}

TEST(HarmonicParts, adds_harmonic_functions_to_a_field) {
  const Field field = solved_field(plate());
  const CadFace& face = field.mesh.face;
  const auto square = [&](int curve, double t) {
    const Vec2 x = curve::point(face.curves[curve], t);
    return Vec2{x.x * x.x - x.y * x.y, 2 * x.x * x.y};
  };
  const auto constant = [](int, double) { return Vec2{0.5, -0.25}; };
  const auto parts = parts_of(field, {{square, {}}, {constant, {}}});
  ASSERT_EQ(parts.size(), 2u);
  Field sum = field;
  field::add(parts[0], 2, sum);
  field::add(parts[1], -1, sum);
  for (const Vec2 x : {Vec2{0.3, 0.4}, Vec2{2.5, 1.5}, Vec2{3.3, 2.2}}) {
    const Vec2 added = value_at(sum, x) - value_at(field, x);
    EXPECT_NEAR(added.x, 2 * (x.x * x.x - x.y * x.y) - 0.5, 1e-10);
    EXPECT_NEAR(added.y, 4 * x.x * x.y + 0.25, 1e-10);
  }
}

TEST(HarmonicParts, liftings_are_added_to_those_at_the_same_joint) {
  const Field field = solved_field(plate());
  const CadFace& face = field.mesh.face;
  const Lifting at_a_tie = field.liftings.front();
  const auto minus_lifting = [&face, at_a_tie](int curve, double t) {
    return -1 * field::liftings_on_boundary(face, {at_a_tie}, curve, t);
  };
  Field sum = field;
  field::add(parts_of(field, {{minus_lifting, {at_a_tie}}})[0], 1, sum);  // the data add up to nothing
  EXPECT_EQ(sum.liftings.size(), field.liftings.size());
  EXPECT_NEAR(norm(sum.liftings.front().jump - 2 * at_a_tie.jump), 0, 1e-14);
  EXPECT_NEAR(norm(value_at(sum, {2.5, 1.5}) - value_at(field, {2.5, 1.5})), 0, 1e-6);
}

TEST(HarmonicParts, elements_where_a_function_vanishes_are_left_out) {
  const Field field = solved_field(plate());
  const auto parts = parts_of(field, {{[](int, double) { return Vec2{}; }, {}}});
  EXPECT_TRUE(parts[0].elems.empty());
}

TEST(HarmonicParts, elements_where_a_function_is_negligible_are_left_out) {
  const Field field = solved_field(polygon_face({{0, 0}, {20, 0}, {20, 1}, {0, 1}}));
  const CadFace& face = field.mesh.face;
  const auto at_one_end = [&](int curve, double t) {
    const Vec2 x = curve::point(face.curves[curve], t);
    return x.x < 1e-9 ? Vec2{std::sin(pi * x.y), 0} : Vec2{};
  };
  PhaseSolver solver(field.mesh, field.elem_order);
  const auto part = solver.harmonic_parts({{at_one_end, {}}}, 1e-6)[0];
  const field::FieldEvaluator evaluator(field);
  for (const int elem : part.elems) EXPECT_LT(evaluator.maps()[elem].position(field::centroid).x, 10);
  Field sum = field, whole = field;
  field::add(part, 1, sum);
  field::add(solver.harmonic_parts({{at_one_end, {}}})[0], 1, whole);
  for (const Vec2 x : {Vec2{0.5, 0.4}, Vec2{2, 0.3}, Vec2{4, 0.5}, Vec2{12, 0.5}}) {
    EXPECT_NEAR(value_at(sum, x).x - value_at(field, x).x, std::sin(pi * x.y) * std::exp(-pi * x.x), 1e-3);
    EXPECT_LT(distance(value_at(sum, x), value_at(whole, x)), 1e-5);
  }
}

}  // namespace
}  // namespace quadrille::galerkin
