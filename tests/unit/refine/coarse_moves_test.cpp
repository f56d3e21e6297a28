#include "refine/coarse_moves.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../hand_made.hpp"
#include "../support/refined.hpp"
#include "refine/size_energy.hpp"

namespace quadrille::refine {
namespace {

QuadMesh mesh_of(const SeparatrixGraph& graph, double size) {
  return refined(graph, {.size = size, .order = 2, .geometry_tol = 1e-2, .relax = Relax::none});
}

/// The preconditioner of a mesh where its vertices are.
struct Preconditioner {
  explicit Preconditioner(const QuadMesh& mesh) : problem(mesh, {}), moves(problem) {
    SizeEnergy energy(problem, mesh);
    energy.set_sizes(std::vector<Vec2>(mesh.num_elems(), Vec2{1, 1}));
    const EnergyDerivatives at = energy.with_derivatives(VertexMoves(problem.num_vertices()), true);
    moves.set_blocks(at.blocks, energy.curve_tangents());
  }

  /// Of moves that vertices may make.
  VertexMoves sample(double phase) const {
    VertexMoves sample(problem.num_vertices());
    for (int v = 0; v < problem.num_vertices(); ++v) {
      if (!problem.is_fixed[v]) sample[v] = {std::sin(phase * (v + 1)), std::cos(phase * (v + 1))};
      if (problem.follow.on_boundary(v) >= 0) sample[v].y = 0;
    }
    return sample;
  }

  RelaxProblem problem;
  CoarseMoves moves;
};

double inner_product(const VertexMoves& a, const VertexMoves& b) {
  double sum = 0;
  for (std::size_t v = 0; v < a.size(); ++v) sum += dot(a[v], b[v]);
  return sum;
}

/// Blocks with even and odd numbers of elements, with one of them, several, and with sides on two curves.
TEST(CoarseMoves, AreASymmetricPositiveMatrix) {
  for (const SeparatrixGraph& graph : {hand_made::unit_square(), hand_made::cut_annulus(3), hand_made::l_shape()})
    for (const double size : {1.0 / 7, 1.0 / 8, 0.6}) {
      const Preconditioner on(mesh_of(graph, size));
      const VertexMoves a = on.sample(1), b = on.sample(2.5), a_moves = on.moves(a), b_moves = on.moves(b);
      EXPECT_NEAR(inner_product(a, b_moves), inner_product(b, a_moves), 1e-9 * inner_product(a, a_moves));
      EXPECT_GT(inner_product(b, b_moves), 0);
    }
}

TEST(CoarseMoves, MoveOnlyWhatMayMove) {
  const Preconditioner on(mesh_of(hand_made::cut_annulus(3), 0.3));
  const VertexMoves moves = on.moves(on.sample(1));
  for (int v = 0; v < on.problem.num_vertices(); ++v) {
    if (on.problem.is_fixed[v]) {
      EXPECT_EQ(moves[v], Vec2{});
    }
    if (on.problem.follow.on_boundary(v) >= 0) {
      EXPECT_EQ(moves[v].y, 0);
    }
  }
}

/// What all neighbours are to do at once they do as far in one step however many they are.
TEST(CoarseMoves, ReachAsFarInAFineMesh) {
  const auto middle_of_common = [](double size) {
    const Preconditioner on(mesh_of(hand_made::unit_square(), size));
    VertexMoves common(on.problem.num_vertices());
    for (int v = 0; v < on.problem.num_vertices(); ++v)
      if (on.problem.follow.on_boundary(v) < 0) common[v] = {1, 0};
    double greatest = 0;
    for (const Vec2 move : on.moves(common)) greatest = std::max(greatest, move.x / (size * size));
    return greatest;
  };
  // Over size^2 the solution of the continuous problem is 16 times as large, that of the diagonal blocks the same.
  EXPECT_GT(middle_of_common(1.0 / 32), 10 * middle_of_common(1.0 / 8));
}

}  // namespace
}  // namespace quadrille::refine
