// Fields and nodes of faces with slits: triangulate, galerkin, adapt and choice together.

#include <gtest/gtest.h>

#include <algorithm>

#include "../support/polygon_field.hpp"
#include "../triangulate/faces.hpp"
#include "choice/choose_nodes.hpp"
#include "field/error_estimate.hpp"
#include "field/evaluate.hpp"
#include "galerkin/solve_phase.hpp"

namespace quadrille::choice {
namespace {

/// A unit square with a slit that bends by `turn` radians in the middle of the square.
CadFace bent_slit(double turn) {
  const Vec2 a{0.25, 0.5}, b{0.5, 0.5}, c = b + 0.25 * unit(turn);
  CadFace face = testing_faces::make_face({testing_faces::polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}),  //
                                           testing_faces::polygon({a, b, c, b})});
  testing_faces::pair_sides(face, 4, 7);
  testing_faces::pair_sides(face, 5, 6);
  return face;
}

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

// The bridges over the jumps are as short as the innermost ring of the fans. Shorter ones change nothing.
TEST(Slits, BridgesOverJumpsDoNotDisturbTheField) {
  const CadFace face = bent_slit(radians(30.0));
  const Field field = adapted_field(face);
  triangulate::TriangulateOptions options;
  options.fan_layers = 10;
  Report report;
  const TriMesh deeper = triangulate::triangulate(face, options, report);
  ASSERT_GT(deeper.num_elems(), field.mesh.num_elems());
  const Field reference =
      adapt::adapt_loop(galerkin::solve_laplace(deeper, std::vector<int>(deeper.num_elems(), 8), report), {}, report);
  const field::FieldEvaluator evaluator(field), reference_evaluator(reference);
  for (const Vec2 x : {Vec2{0.5, 0.55}, {0.51, 0.49}, {0.7, 0.7}, {0.1, 0.5}}) {
    Vec2 value, expected;
    ASSERT_TRUE(evaluator.value_at(x, value));
    ASSERT_TRUE(reference_evaluator.value_at(x, expected));
    EXPECT_NEAR(distance(value, expected), 0, 1e-7) << x.x << ' ' << x.y;
  }
}

TEST(Slits, BentOnesHaveNodesThatClose) {
  for (const double turn : {30.0, 90.0}) {
    const Field field = adapted_field(bent_slit(radians(turn)));
    const CriticalPoints points = nodes_of(field);
    EXPECT_EQ(index_sum_of(points), 0);
    const Field phase = phase_of(field, points);
    const field::FieldEvaluator evaluator(phase);
    Vec2 value;
    ASSERT_TRUE(evaluator.value_at({0.4, 0.501}, value));
    EXPECT_NEAR(distance(value, {1, 0}), 0, 0.02) << "aligned with the slit beside it";
  }
}

}  // namespace
}  // namespace quadrille::choice
