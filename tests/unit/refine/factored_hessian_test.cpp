#include "refine/factored_hessian.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../hand_made.hpp"
#include "../support/refined.hpp"
#include "refine/inverse_hessian.hpp"

namespace quadrille::refine {
namespace {

/// The energy of a mesh with vertices near the places where they are.
struct Moved {
  Moved(const SeparatrixGraph& graph, double size)
      : mesh(refined(graph, {.size = size, .order = 3, .geometry_tol = 1e-2, .relax = Relax::none})),
        problem(mesh, {}),
        energy(problem, mesh),
        moves(sample(3, 0.01)) {
    energy.set_sizes(std::vector<Vec2>(mesh.num_elems(), Vec2{size, size}));
  }

  /// Moves that vertices may make.
  VertexMoves sample(double phase, double length) const {
    VertexMoves sample(problem.num_vertices());
    for (int v = 0; v < problem.num_vertices(); ++v) {
      if (!problem.is_fixed[v]) sample[v] = length * Vec2{std::sin(phase * (v + 1)), std::cos(phase * (v + 1))};
      if (problem.follow.on_boundary(v) >= 0) sample[v].y = 0;
    }
    return sample;
  }

  VertexMoves gradient(double length, const VertexMoves& direction) {
    VertexMoves at = moves;
    add_multiple(length, direction, at);
    return energy.with_derivatives(at).gradient;
  }

  /// The change of the gradient along a direction.
  VertexMoves bend(const VertexMoves& direction) {
    const double h = 1e-6;
    VertexMoves bend = gradient(h, direction);
    add_multiple(-1, gradient(-h, direction), bend);
    for (Vec2& x : bend) x *= 1 / (2 * h);
    return bend;
  }

  QuadMesh mesh;
  RelaxProblem problem;
  SizeEnergy energy;
  VertexMoves moves;
};

/// Of the change of the gradient.
void expect_inverse(Moved& on) {
  const VertexMoves direction = on.sample(1, 1), bend = on.bend(direction);
  on.energy.value(on.moves);
  FactoredHessian inverse(on.problem);
  inverse.set(on.energy.hessians(), on.energy);
  const VertexMoves found = inverse(bend);
  for (int v = 0; v < on.problem.num_vertices(); ++v) EXPECT_LT(distance(found[v], direction[v]), 1e-4) << v;
}

TEST(FactoredHessian, IsTheInverseOfTheChangeOfTheGradient) {
  // Nearly equal squares have no negative curvature.
  Moved on(hand_made::unit_square(), 0.2);
  expect_inverse(on);
}

TEST(FactoredHessian, IsTheInverseWithAMetricAndDirections) {
  Moved on(hand_made::unit_square(), 0.2);
  // Sides along the directions, and nearly squares in the metric.
  on.energy.stretches.assign(on.mesh.num_elems(), tensor_of({1.05, 1 / 1.05, 0.4}));
  on.energy.directions.assign(on.mesh.num_elems(), {3, 0});
  on.energy.set_sizes(std::vector<Vec2>(on.mesh.num_elems(), Vec2{0.2, 0.2}));
  expect_inverse(on);
}

TEST(FactoredHessian, HasNoNegativeCurvatureAndAllThatIsPositive) {
  for (const SeparatrixGraph& graph : {hand_made::cut_annulus(3), hand_made::quarter_annulus()}) {
    Moved on(graph, 0.35);
    for (const double phase : {1.0, 2.5, 0.3}) {
      const VertexMoves direction = on.sample(phase, 1), bend = on.bend(direction);
      on.energy.value(on.moves);
      double curvature = 0;
      const std::vector<ElementHessian> hessians = on.energy.hessians();
      for (int elem = 0; elem < on.mesh.num_elems(); ++elem) {
        Eigen::Matrix<double, 8, 1> d;
        for (int c = 0; c < 4; ++c) {
          const Vec2 x = direction[on.problem.follow.elem_vertices()[elem][c]];
          d.segment<2>(2 * c) << x.x, x.y;
        }
        curvature += d.dot(hessians[elem] * d);
      }
      const double exact = inner_product(direction, bend);
      EXPECT_GE(curvature, exact * (1 - 1e-4));
      EXPECT_LE(curvature, 2 * exact);
    }
  }
}

TEST(FactoredHessian, MovesOnlyWhatMayMove) {
  Moved on(hand_made::quarter_annulus(), 0.3);
  const EnergyDerivatives at = on.energy.with_derivatives(on.moves);
  FactoredHessian inverse(on.problem);
  inverse.set(on.energy.hessians(), on.energy);
  const VertexMoves moves = inverse(at.gradient);
  EXPECT_GT(inner_product(moves, at.gradient), 0);
  for (int v = 0; v < on.problem.num_vertices(); ++v) {
    if (on.problem.is_fixed[v]) {
      EXPECT_EQ(moves[v], Vec2{});
    }
    if (on.problem.follow.on_boundary(v) >= 0) {
      EXPECT_EQ(moves[v].y, 0);
    }
  }
}

}  // namespace
}  // namespace quadrille::refine
