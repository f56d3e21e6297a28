#include "refine/relax.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "../hand_made.hpp"
#include "../support/refined.hpp"
#include "curve/project.hpp"
#include "refine/validity.hpp"

namespace quadrille::refine {
namespace {

RelaxState state_of(const RelaxProblem& problem, VertexMoves moves) {
  RelaxState state{problem.start, std::move(moves), 0};
  state.mesh.nodes = problem.follow.nodes(state.moves);
  state.energy = problem.total_energy(state.mesh.nodes);
  measure_elements(state.mesh);
  return state;
}

/// Moves of one vertex, by `move`, and of none.
struct OneMove {
  VertexMoves none, one;
  int vertex = -1;

  OneMove(const RelaxProblem& problem, bool on_boundary, Vec2 move)
      : none(problem.num_vertices()), one(problem.num_vertices()) {
    for (int v = 0; v < problem.num_vertices() && vertex < 0; ++v)
      if (!problem.is_fixed[v] && (problem.follow.on_boundary(v) >= 0) == on_boundary) vertex = v;
    one[vertex] = move;
  }
};

TEST(RelaxLimits, MovesThatImproveTheWorstElementStay) {
  // One vertex of a regular mesh was moved away: moving it back breaks no limit.
  const QuadMesh mesh = refined(hand_made::unit_square(), {0.25, 2, 5e-7});
  const RelaxProblem problem(mesh, {});
  const OneMove move(problem, false, {0.03, 0.02});
  const RelaxState state = state_of(problem, move.one);
  RelaxState trial = state_of(problem, move.none);
  EXPECT_FALSE(reset_forbidden_moves(problem, state, 1, trial));
  EXPECT_EQ(trial.moves, move.none);
}

TEST(RelaxLimits, MovesThatMakeAnElementWorseThanTheWorstAreReset) {
  const QuadMesh mesh = refined(hand_made::unit_square(), {0.25, 2, 5e-7});
  const RelaxProblem problem(mesh, {});
  const OneMove move(problem, false, {0.03, 0.02});
  const RelaxState state = state_of(problem, move.none);
  RelaxState trial = state_of(problem, move.one);
  EXPECT_TRUE(reset_forbidden_moves(problem, state, 1, trial));
  EXPECT_EQ(trial.moves, move.none);
}

TEST(RelaxLimits, MeasuresOfMovedElementsAreNewAndOthersAreKept) {
  const QuadMesh mesh = refined(hand_made::unit_square(), {0.25, 2, 5e-7});
  const RelaxProblem problem(mesh, {});
  const OneMove move(problem, false, {0.03, 0.02});
  RelaxState state = state_of(problem, move.none), trial = state_of(problem, move.one);
  const std::vector<double> measured = trial.mesh.elem_scaled_jacobian;
  std::fill(trial.mesh.elem_scaled_jacobian.begin(), trial.mesh.elem_scaled_jacobian.end(), -7);
  reset_forbidden_moves(problem, state, 1, trial);
  for (int elem = 0; elem < mesh.num_elems(); ++elem)
    EXPECT_NEAR(trial.mesh.elem_scaled_jacobian[elem], measured[elem], 1e-12) << elem;
}

TEST(RelaxLimits, MovesThatTakeTheBoundaryOutOfItsToleranceAreReset) {
  // On a ring all elements are alike under a turn: only the boundary's tolerance can stand against the move of a ring.
  const QuadMesh mesh = refined(hand_made::cut_annulus(3), {0.3, 2, 1e-2});
  const RelaxProblem problem(mesh, {});
  VertexMoves turned(problem.num_vertices());
  for (int v = 0; v < problem.num_vertices(); ++v) {
    const int b = problem.follow.on_boundary(v);
    if (b >= 0) turned[v] = {problem.boundary.vertices()[b].loop == 0 ? 1e-3 : 0.0, 0};
  }
  const RelaxState state = state_of(problem, VertexMoves(problem.num_vertices()));
  double error = 0;
  for (int e = 0; e < static_cast<int>(problem.boundary.edges().size()); ++e)
    error = std::max(error, problem.boundary.edge_error(e, 0, 0));
  RelaxState tight = state_of(problem, turned);
  EXPECT_TRUE(reset_forbidden_moves(problem, state, error / 2, tight));
  EXPECT_EQ(tight.moves, state.moves);
}

/// The unit square with skewed elements inside.
QuadMesh skew_square() {
  QuadMesh mesh = refined(hand_made::unit_square(), {0.25, 2, 5e-7});
  for (Vec2& x : mesh.nodes) x += 0.2 * x.x * (1 - x.x) * x.y * (1 - x.y) * Vec2{4 * x.y, 3 + x.x};
  return mesh;
}

TEST(ConjugateDescent, ASmallStepLowersTheEnergy) {
  const QuadMesh mesh = skew_square();
  const RelaxProblem problem(mesh, {});
  VertexMoves moves(problem.num_vertices());
  ConjugateDescent descent(problem);
  double before = problem.total_energy(mesh.nodes);
  for (int step = 0; step < 3; ++step) {
    const VertexMoves direction = descent.next(problem.follow.nodes(moves), moves);
    for (std::size_t v = 0; v < moves.size(); ++v) moves[v] += 0.1 * direction[v];
    const double after = problem.total_energy(problem.follow.nodes(moves));
    EXPECT_LT(after, before) << step;
    before = after;
  }
}

TEST(ConjugateDescent, FixedVerticesAndFrozenElementsStay) {
  const QuadMesh mesh = skew_square();
  std::vector<bool> frozen(mesh.num_elems(), false);
  frozen[5] = true;
  const RelaxProblem problem(mesh, frozen);
  const VertexMoves direction = ConjugateDescent(problem).next(mesh.nodes, VertexMoves(problem.num_vertices()));
  int num_fixed = 0;
  for (int v = 0; v < problem.num_vertices(); ++v)
    if (problem.is_fixed[v]) {
      EXPECT_EQ(direction[v], Vec2{});
      ++num_fixed;
    }
  EXPECT_EQ(num_fixed, 8) << "the corners of the square and of the frozen element";
}

TEST(ConjugateDescent, NoVertexMovesByMoreThanAQuarterOfTheShortestEdge) {
  QuadMesh mesh = skew_square();
  const RelaxProblem problem(mesh, {});
  double shortest = 1e300;
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const int* n = &mesh.elem_nodes[elem * 9];
    for (const auto& [a, b] : {std::pair{0, 2}, {2, 8}, {8, 6}, {6, 0}})
      shortest = std::min(shortest, distance(mesh.nodes[n[a]], mesh.nodes[n[b]]));
  }
  ASSERT_LT(shortest, 0.25);
  for (const Vec2 move : ConjugateDescent(problem).next(mesh.nodes, VertexMoves(problem.num_vertices())))
    EXPECT_LE(norm(move), 0.25 * 0.4);
}

TEST(ConjugateDescent, VerticesOnTheBoundaryMoveAlongIt) {
  const QuadMesh mesh = refined(hand_made::quarter_annulus(), {0.4, 2, 1e-2});
  const RelaxProblem problem(mesh, {});
  const VertexMoves direction = ConjugateDescent(problem).next(mesh.nodes, VertexMoves(problem.num_vertices()));
  for (int v = 0; v < problem.num_vertices(); ++v)
    if (problem.follow.on_boundary(v) >= 0) {
      EXPECT_EQ(direction[v].y, 0);
    }
}

/// The unit square, inner nodes moved by `move`.
QuadMesh moved_square(int order, const std::function<Vec2(Vec2)>& move) {
  QuadMesh mesh = refined(hand_made::unit_square(), {0.25, order, 5e-7});
  for (Vec2& x : mesh.nodes) x += move(x);
  measure_elements(mesh);
  return mesh;
}

/// Zero on the boundary, and the same in all eight symmetries of the square.
Vec2 symmetric_move(Vec2 x) {
  const auto bulge = [](double t) { return std::sin(pi * t) * std::sin(pi * t); };
  return 0.07 * Vec2{std::sin(2 * pi * x.x) * bulge(x.y), std::sin(2 * pi * x.y) * bulge(x.x)};
}

Vec2 skew_move(Vec2 x) { return 0.2 * x.x * (1 - x.x) * x.y * (1 - x.y) * Vec2{4 * x.y, 3 + x.x}; }

double least(const QuadMesh& mesh) {
  return *std::min_element(mesh.elem_scaled_jacobian.begin(), mesh.elem_scaled_jacobian.end());
}

double distance_to_set(Vec2 x, const std::vector<Vec2>& set) {
  double nearest = 1e300;
  for (const Vec2 y : set) nearest = std::min(nearest, distance(x, y));
  return nearest;
}

std::vector<int> boundary_nodes(const QuadMesh& mesh) {
  std::vector<int> nodes;
  const int n = mesh.order, width = n + 1;
  for (const QuadBoundaryEdge& e : mesh.boundary_edges)
    for (int k = 0; k <= n; ++k) {
      const int local[4] = {k, k * width + n, n * width + n - k, (n - k) * width};
      nodes.push_back(mesh.elem_nodes[e.elem * width * width + local[e.side]]);
    }
  return nodes;
}

TEST(Relax, RightensASkewMeshOfTheSquare) {
  for (const int order : {1, 2, 5}) {
    QuadMesh mesh = moved_square(order, skew_move);
    const double before = least(mesh);
    ASSERT_LT(before, 0.98);
    const RelaxOutcome outcome = relax(mesh, {50, 1e-6, {}});
    EXPECT_GT(outcome.sweeps, 0);
    EXPECT_LT(outcome.energy_after, outcome.energy_before);
    EXPECT_GT(outcome.largest_move, 0);
    EXPECT_GT(least(mesh), (1 + before) / 2) << order << ": half of what is missing at least";
    EXPECT_TRUE(mesh.is_valid);
  }
}

TEST(Relax, LeavesAPerfectMeshAlone) {
  QuadMesh mesh = moved_square(3, [](Vec2) { return Vec2{}; });
  const std::vector<Vec2> before = mesh.nodes;
  EXPECT_EQ(relax(mesh, {20, 1e-6, {}}).sweeps, 0);
  EXPECT_EQ(mesh.nodes, before);
}

TEST(Relax, NeverMakesTheWorstWorseAndKeepsTheBoundaryOnItsCurves) {
  for (const int order : {1, 2, 4, 7})
    for (const SeparatrixGraph& graph : {hand_made::elbow(), hand_made::s_bend(), hand_made::cut_annulus(3)})
      for (const int sweeps : {1, 5, 40}) {
        const double tolerance = order == 1 ? 1e-2 : 1e-3;
        QuadMesh mesh = refined(graph, {0.4, order, tolerance});
        const double before = least(mesh);
        const std::vector<Vec2> joints = [&] {
          std::vector<Vec2> places;
          for (const Joint& joint : mesh.face.joints) places.push_back(joint.position);
          return places;
        }();
        std::vector<double> gaps;
        for (const Vec2 x : joints) gaps.push_back(distance_to_set(x, mesh.nodes));
        relax(mesh, {sweeps, tolerance * mesh.face.diameter, {}});
        EXPECT_GE(least(mesh), before - 1e-11);
        EXPECT_GT(mesh.least_jacobian_bound, 0);
        for (const int node : boundary_nodes(mesh)) {
          double nearest = 1e300;
          for (const Nurbs& curve : mesh.face.curves)
            nearest = std::min(nearest, curve::project(curve, mesh.nodes[node]).distance);
          EXPECT_LT(nearest, 1e-11);
        }
        for (std::size_t k = 0; k < joints.size(); ++k)
          if (gaps[k] < 1e-12 && mesh.face.joints[k].is_corner) {
            EXPECT_LT(distance_to_set(joints[k], mesh.nodes), 1e-12) << "corners stay";
          }
      }
}

TEST(Relax, SymmetricMeshesStaySymmetric) {
  for (const int order : {1, 2, 4}) {
    QuadMesh mesh = moved_square(order, symmetric_move);
    const double before = least(mesh);
    relax(mesh, {30, 1e-6, {}});
    EXPECT_GT(least(mesh), before);
    for (const Vec2 x : mesh.nodes)
      for (const Vec2 image : {Vec2{1 - x.x, x.y}, Vec2{x.x, 1 - x.y}, Vec2{x.y, x.x}, Vec2{1 - x.y, x.x}})
        EXPECT_LT(distance_to_set(image, mesh.nodes), 1e-11);
  }
}

TEST(Relax, FrozenElementsKeepTheirNodesBitForBit) {
  QuadMesh mesh = moved_square(3, skew_move);
  const QuadMesh before = mesh;
  std::vector<bool> frozen(mesh.num_elems(), false);
  for (const int elem : {5, 6, 7}) frozen[elem] = true;
  relax(mesh, {30, 1e-6, frozen});
  for (const int elem : {5, 6, 7}) EXPECT_EQ(element_nodes(mesh, elem), element_nodes(before, elem));
  EXPECT_NE(mesh.nodes, before.nodes) << "the others move";
}

TEST(Relax, NoSweepsAndMeshesThatAreNotValidChangeNothing) {
  QuadMesh mesh = moved_square(2, skew_move);
  const std::vector<Vec2> before = mesh.nodes;
  EXPECT_EQ(relax(mesh, {0, 1e-6, {}}).sweeps, 0);
  EXPECT_EQ(mesh.nodes, before);
  mesh.is_valid = false;
  EXPECT_EQ(relax(mesh, {10, 1e-6, {}}).sweeps, 0);
  EXPECT_EQ(mesh.nodes, before);
}

TEST(Relax, GivesTheSameBytesTwice) {
  QuadMesh a = refined(hand_made::elbow(), {0.4, 4, 1e-4}), b = a;
  relax(a, {15, 1e-3, {}});
  relax(b, {15, 1e-3, {}});
  EXPECT_EQ(a.nodes, b.nodes);
}

}  // namespace
}  // namespace quadrille::refine
