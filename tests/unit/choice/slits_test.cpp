// Fields and nodes of faces with slits: triangulate, galerkin, adapt and choice together.

#include <gtest/gtest.h>

#include <algorithm>

#include "../support/polygon_field.hpp"
#include "../triangulate/faces.hpp"
#include "choice/choose_nodes.hpp"
#include "field/corner_tilt.hpp"
#include "field/error_estimate.hpp"
#include "field/evaluate.hpp"
#include "galerkin/solve_phase.hpp"

namespace quadrille::choice {
namespace {

using testing_faces::bent_slit;

CriticalPoints nodes_of(Field field) {
  field.elem_error = field::error_estimate(field);
  Report report;
  return choose_nodes(field, {}, 1, report);
}

Field phase_of(const Field& field, const CriticalPoints& points) {
  galerkin::PhaseSolver solver(field.mesh, field.elem_order);
  Report report;
  return solver.solve(phase_nodes_of(points), {}, report);
}

TEST(Slits, TheirTipsHaveFourBlocksAndNeedNoNode) {
  const CriticalPoints points = nodes_of(adapted_field(testing_faces::slit_square()));
  EXPECT_TRUE(points.critical_points.empty());
  EXPECT_EQ(index_sum_of(points), 0);
  EXPECT_EQ(std::count_if(points.corners.begin(), points.corners.end(), [](const Corner& c) { return c.valence == 4; }),
            2);
}

TEST(Slits, AFieldAlongTheAxesIsExactOnBothSides) {
  const Field field = adapted_field(testing_faces::slit_square());
  const Field phase = phase_of(field, nodes_of(field));
  for (const Field* f : {&field, &phase}) {
    const field::FieldEvaluator evaluator(*f);
    for (const Vec2 x : {Vec2{0.5, 0.51}, {0.5, 0.49}, {0.29, 0.5}, {0.9, 0.1}}) {
      Vec2 value;
      ASSERT_TRUE(evaluator.value_at(x, value));
      EXPECT_NEAR(distance(value, {1, 0}), 0, 1e-9);
    }
  }
}

/// The field with more rings in the fans than are chosen, on which `of` solves.
template <typename Of>
void expect_same_with_shorter_bridges(const CadFace& face, const Of& of, double tolerance,
                                      const std::vector<Vec2>& points) {
  const Field field = adapted_field(face);
  triangulate::TriangulateOptions options;
  options.fan_layers = 12;
  Report report;
  const TriMesh deeper = triangulate::triangulate(face, options, report);
  ASSERT_GT(deeper.num_elems(), field.mesh.num_elems());
  const Field reference =
      adapt::adapt_loop(galerkin::solve_laplace(deeper, std::vector<int>(deeper.num_elems(), 8), report), {}, report);
  const Field first = of(field), second = of(reference);
  const field::FieldEvaluator evaluator(first), reference_evaluator(second);
  for (const Vec2 x : points) {
    Vec2 value, expected;
    ASSERT_TRUE(evaluator.value_at(x, value));
    ASSERT_TRUE(reference_evaluator.value_at(x, expected));
    EXPECT_NEAR(distance(value, expected), 0, tolerance) << x.x << ' ' << x.y;
  }
}

// The bridges over the jumps are as short as the innermost ring of the fans. Shorter ones change nothing.
TEST(Slits, BridgesOverJumpsDoNotDisturbTheField) {
  const auto harmonic = [](const Field& field) { return field; };
  expect_same_with_shorter_bridges(bent_slit(radians(30.0)), harmonic, 1e-7,
                                   {{0.5, 0.55}, {0.51, 0.49}, {0.7, 0.7}, {0.1, 0.5}});
  expect_same_with_shorter_bridges(testing_faces::pinched_square(), harmonic, 1e-7,
                                   {{-0.3, 0.1}, {0.4, -0.2}, {0.02, 0}, {1.5, 1.5}});
}

/// One node, and the corners of an acute bend, whose turns are centred in the bend: the sum of 2 - V is -5 there.
PhaseNodes nodes_at_an_acute_bend(Vec2 x) {
  return {{{x, 3}}, {{0, 1}, {1, 1}, {2, 1}, {3, 1}, {4, 4}, {5, 1}, {6, 4}, {7, 4}}, {}};
}

TEST(Slits, AcuteBendsHaveTheirTurnsInTheBend) {
  const auto phase = [](const Field& field) {
    galerkin::PhaseSolver solver(field.mesh, field.elem_order);
    Report report;
    return solver.solve(nodes_at_an_acute_bend({0.4, 0.54}), {}, report);
  };
  const CadFace face = bent_slit(radians(150.0));
  expect_same_with_shorter_bridges(face, phase, 1e-6, {{0.6, 0.5}, {0.35, 0.52}, {0.4, 0.4}, {0.9, 0.9}});
  const Field field = phase(adapted_field(face));
  EXPECT_EQ(field.phase.terms.holes.at(0).turns, -1);
  EXPECT_EQ(distance(field.phase.terms.holes.at(0).position, {0.5, 0.5}), 0);
  const field::FieldEvaluator evaluator(field);
  for (const Vec2 x : {Vec2{0.4, 0.4999}, {0.3, 0.5001}, {0.5, 0.0001}, {0.9999, 0.3}}) {
    Vec2 value;
    ASSERT_TRUE(evaluator.value_at(x, value));
    EXPECT_NEAR(distance(value, {1, 0}), 0, 0.01) << "aligned with slit and outline at " << x.x << ' ' << x.y;
  }
}

TEST(Slits, TiltsAtTheirTiesAreBridged) {
  Report report;
  const TriMesh mesh = triangulate::triangulate(bent_slit(radians(135.0)), {}, report);
  const field::LiftedData data = field::tilt_data(mesh, {5, 7}, field::TiltPart::even);
  EXPECT_TRUE(data.liftings.empty());
  for (const int joint : {5, 7}) {
    const int before = mesh.face.previous_in_loop(joint);
    const Vec2 in = data.values(before, mesh.face.curves[before].end());
    EXPECT_NEAR(distance(in, data.values(joint, mesh.face.curves[joint].begin())), 0, 1e-12);
  }
}

TEST(Slits, BentOnesHaveNodesThatClose) {
  for (const double turn : {30.0, 90.0, 140.0, 155.0}) {
    const Field field = adapted_field(bent_slit(radians(turn)));
    const CriticalPoints points = nodes_of(field);
    EXPECT_EQ(index_sum_of(points), 0);
    const Field phase = phase_of(field, points);
    const field::FieldEvaluator evaluator(phase);
    Vec2 value;
    ASSERT_TRUE(evaluator.value_at({0.4, 0.499}, value));
    EXPECT_NEAR(distance(value, {1, 0}), 0, 0.02) << "aligned with the slit beside it";
  }
}

}  // namespace
}  // namespace quadrille::choice
