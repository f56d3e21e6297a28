#include "galerkin/aligned_field.hpp"

#include <gtest/gtest.h>

#include "../support/texts.hpp"
#include "../test_meshes.hpp"
#include "../triangulate/faces.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "field/error_estimate.hpp"
#include "field/evaluate.hpp"
#include "galerkin/solve_laplace.hpp"
#include "galerkin/solve_phase.hpp"
#include "plane_functions.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille::galerkin {
namespace {

using namespace testing_faces;

/// In the middle of the unit square.
Alignment in_the_middle(double angle, double rate) { return {{{0.5, 0.5}, 0.15, rate, angle}}; }

CadFace unit_square() { return make_face({polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}})}); }

LaplaceOptions aligned(Alignment alignment) {
  LaplaceOptions options;
  options.alignment = std::move(alignment);
  return options;
}

struct AlignedField : testing::Test {
  Report report;
  Field solved(const CadFace& face, int order, const LaplaceOptions& options) {
    const TriMesh mesh = triangulate::triangulate(face, {}, report);
    return solve_laplace(mesh, std::vector<int>(mesh.num_elems(), order), options, report);
  }
  static Vec2 at(const Field& field, Vec2 x) {
    Vec2 value;
    EXPECT_TRUE(field::FieldEvaluator(field).value_at(x, value));
    return value;
  }
};

TEST_F(AlignedField, PolynomialsAreExact) {
  const TriMesh mesh = parallelogram_mesh({0, 0}, {1, 0}, {0, 1}, 3);
  const MeshContext context(mesh);
  const Alignment alignment = in_the_middle(0, 40);
  const field::AlignmentTerm term(alignment);
  const std::vector<int> orders(mesh.num_elems(), 6);
  // -Δv + mu v of v = cube, whose Laplacian is 0
  const ValuesInElement f = [&](int, const std::vector<Vec2>& points) {
    Eigen::MatrixXd values(std::ssize(points), 2);
    for (Eigen::Index q = 0; q < values.rows(); ++q) {
      const Vec2 x = points[static_cast<std::size_t>(q)], value = term.at(x).rate * cube(x);
      values.row(q) << value.x, value.y;
    }
    return values;
  };
  ContinuousGalerkin method(context, on_boundary(mesh, cube), 1, &term, f);
  const Solution solution = method.solve(orders);
  EXPECT_LT(greatest_error(context, orders, solution.elem_coefs, cube), 1e-12);
  EXPECT_LT(solution.residual, 1e-12);
}

TEST_F(AlignedField, WithoutAnAlignmentNothingChanges) {
  const Field plain = solved(unit_square(), 8, {}), same = solved(unit_square(), 8, aligned({}));
  EXPECT_EQ(plain.u, same.u);
  EXPECT_EQ(plain.v, same.v);
}

TEST_F(AlignedField, CrossesTurnTowardsThePrescribedDirection) {
  double before = 0;
  for (const double rate : {10.0, 100.0, 1000.0}) {
    const Field field = solved(unit_square(), 10, aligned(in_the_middle(0.3, rate)));
    const Vec2 middle = at(field, {0.5, 0.5});
    EXPECT_GT(angle_of(middle) / 4, before);
    EXPECT_LT(angle_of(middle) / 4, 0.3);
    EXPECT_LE(norm(middle), 1);
    before = angle_of(middle) / 4;
  }
  EXPECT_GT(before, 0.25);
}

TEST_F(AlignedField, ItConvergesWithTheOrderAlsoBesideJumpsOfTheData) {
  const CadFace triangle = make_face({polygon({{0, 0}, {1, 0}, {0.3, 0.8}})});  // its data jump at corners
  const LaplaceOptions options = aligned({{{0.4, 0.3}, 0.15, 60, 0.5}});
  const Field fine = solved(triangle, 18, options);
  ASSERT_FALSE(fine.liftings.empty());
  double before = 1;
  for (const int order : {6, 9, 12}) {
    const Field field = solved(triangle, order, options);
    const double error = distance(at(field, {0.5, 0.2}), at(fine, {0.5, 0.2}));
    EXPECT_LT(error, before / 5);
    before = error;
  }
  EXPECT_LT(before, 1e-7);
}

TEST_F(AlignedField, TheFieldKeepsItsAlignment) {
  const Alignment alignment = in_the_middle(0.3, 50);
  const Field field = solved(unit_square(), 6, aligned(alignment));
  EXPECT_EQ(field.alignment, alignment);
  EXPECT_EQ(options_of(field).alignment, alignment);
}

TEST_F(AlignedField, DiscontinuousElementsAreRefused) {
  LaplaceOptions options = aligned(in_the_middle(0.3, 50));
  options.method = FieldMethod::dg;
  EXPECT_TRUE(contains(message_of<UsageError>([&] { solved(unit_square(), 4, options); }), "continuous"));
}

TEST_F(AlignedField, APhaseTurnsTowardsTheDirectionToo) {
  const TriMesh mesh = triangulate::triangulate(unit_square(), {}, report);
  const std::vector<int> orders(mesh.num_elems(), 10);
  PhaseNodes nodes;
  for (int joint = 0; joint < 4; ++joint) nodes.corners.push_back({joint, 1});
  double before = 0;
  for (const double rate : {10.0, 100.0, 1000.0}) {
    PhaseSolver solver(mesh, orders, 1, in_the_middle(0.3, rate));
    const Field field = solver.solve(nodes, {}, report);
    const Vec2 middle = at(field, {0.5, 0.5});
    EXPECT_NEAR(norm(middle), 1, 1e-12);
    EXPECT_GT(angle_of(middle) / 4, before);
    EXPECT_LT(angle_of(middle) / 4, 0.3);
    before = angle_of(middle) / 4;
    EXPECT_EQ(field.alignment, in_the_middle(0.3, rate));
  }
  EXPECT_GT(before, 0.25);
}

TEST_F(AlignedField, APhaseThatIsAlignedStays) {
  const TriMesh mesh = triangulate::triangulate(unit_square(), {}, report);
  const std::vector<int> orders(mesh.num_elems(), 10);
  PhaseNodes nodes;
  for (int joint = 0; joint < 4; ++joint) nodes.corners.push_back({joint, 1});
  const Field field = PhaseSolver(mesh, orders, 1, in_the_middle(0, 1000)).solve(nodes, {}, report);
  EXPECT_NEAR(distance(at(field, {0.5, 0.5}), {1, 0}), 0, 1e-11);
}

TEST_F(AlignedField, WhatIsAddedToAnAlignedFieldSolvesItsEquation) {
  // The field of other data is that field and what the difference of the data adds.
  const CadFace face = unit_square();
  const TriMesh mesh = triangulate::triangulate(face, {}, report);
  const std::vector<int> orders(mesh.num_elems(), 10);
  const Alignment alignment = in_the_middle(0.3, 200);
  const Field field = solve_laplace(mesh, orders, aligned(alignment), report);
  PhaseSolver solver(mesh, orders, 1, alignment);
  const std::vector<field::HarmonicPart> parts = solver.harmonic_parts({{[](int, double) { return Vec2{-1, 0}; }, {}}});
  // With v = 0 on the boundary, the term alone: |v| is less than with v = 1 there by what the part adds.
  ASSERT_EQ(parts.size(), 1u);
  const field::HarmonicPart& part = parts.front();
  double greatest = 0;
  for (std::size_t i = 0, first = 0; i < part.elems.size(); first += part.num_modes[i], ++i)
    greatest = std::max(greatest, std::abs(part.u[first]));
  EXPECT_LT(greatest, std::sqrt(2.0) + 1e-9) << "-1 everywhere without the term";
  EXPECT_LT(at(field, {0.5, 0.5}).x, 1);
}

}  // namespace
}  // namespace quadrille::galerkin
