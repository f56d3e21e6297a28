#include "refine/relax_problem.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../hand_made.hpp"
#include "../support/refined.hpp"
#include "block/extract_blocks.hpp"
#include "refine/refine.hpp"

namespace quadrille::refine {
namespace {

/// The vertex of a mesh that is nearest to a position.
int vertex_near(const QuadMesh& mesh, const NodeFollow& follow, Vec2 x) {
  int nearest = 0;
  double least = 1e300;
  const int width = mesh.order + 1;
  const std::array<int, 4> corner{0, mesh.order, width * width - 1, width * mesh.order};
  for (int elem = 0; elem < mesh.num_elems(); ++elem)
    for (int c = 0; c < 4; ++c) {
      const double d = distance(mesh.nodes[mesh.elem_nodes[elem * width * width + corner[c]]], x);
      if (d < least) least = d, nearest = follow.elem_vertices()[elem][c];
    }
  return nearest;
}

TEST(NodeFollow, VerticesAreTheCornersOfElements) {
  const QuadMesh mesh = refined(hand_made::unit_square(), {0.25, 3, 5e-7});
  const BoundarySlide boundary(mesh);
  const NodeFollow follow(mesh, boundary);
  EXPECT_EQ(follow.num_vertices(), 25);
  int num_on_boundary = 0;
  for (int v = 0; v < follow.num_vertices(); ++v) {
    if (follow.on_boundary(v) < 0) continue;
    ++num_on_boundary;
    EXPECT_EQ(follow.vertex_of(follow.on_boundary(v)), v);
  }
  EXPECT_EQ(num_on_boundary, 16);
}

TEST(NodeFollow, NodesOfElementsThatDoNotMoveStayBitForBit) {
  const QuadMesh mesh = refined(hand_made::quarter_annulus(), {0.3, 4, 1e-4});
  const BoundarySlide boundary(mesh);
  const NodeFollow follow(mesh, boundary);
  EXPECT_EQ(follow.nodes(VertexMoves(follow.num_vertices())), mesh.nodes);
  VertexMoves moves(follow.num_vertices());
  const int moved = vertex_near(mesh, follow, 1.5 * unit(0.8));
  ASSERT_LT(follow.on_boundary(moved), 0);
  moves[moved] = {0.01, -0.02};
  const std::vector<Vec2> nodes = follow.nodes(moves);
  std::vector<bool> may_move(nodes.size(), false);
  for (int elem = 0; elem < mesh.num_elems(); ++elem)
    for (const int v : follow.elem_vertices()[elem])
      for (int k = 0; v == moved && k < mesh.nodes_per_elem(); ++k)
        may_move[mesh.elem_nodes[elem * mesh.nodes_per_elem() + k]] = true;
  int num_moved = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    num_moved += nodes[i] != mesh.nodes[i];
    if (!may_move[i]) {
      EXPECT_EQ(nodes[i], mesh.nodes[i]) << i;
    }
  }
  EXPECT_GT(num_moved, 9);
}

TEST(NodeFollow, AnAffineMoveOfAllInnerVerticesMovesTheirElementsAffinely) {
  const QuadMesh mesh = refined(hand_made::unit_square(), {0.2, 5, 5e-7});
  const BoundarySlide boundary(mesh);
  const NodeFollow follow(mesh, boundary);
  VertexMoves moves(follow.num_vertices());
  const Vec2 shift{0.03, 0.01};
  for (int v = 0; v < follow.num_vertices(); ++v)
    if (follow.on_boundary(v) < 0) moves[v] = shift;
  const std::vector<Vec2> nodes = follow.nodes(moves);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Vec2 x = mesh.nodes[i];
    const bool is_inside = std::min({x.x, x.y, 1 - x.x, 1 - x.y}) >= 0.2 - 1e-12;
    if (is_inside) {
      EXPECT_LT(distance(nodes[i], x + shift), 1e-14);
    }
  }
}

TEST(NodeFollow, VerticesOnTheBoundarySlideAlongItWithTheNodesBetweenThem) {
  const QuadMesh mesh = refined(hand_made::cut_annulus(3), {0.3, 4, 1e-4});
  const BoundarySlide boundary(mesh);
  const NodeFollow follow(mesh, boundary);
  VertexMoves moves(follow.num_vertices());
  for (int v = 0; v < follow.num_vertices(); ++v)
    if (const int b = follow.on_boundary(v); b >= 0 && boundary.vertices()[b].loop == 0) moves[v] = {0.05, 0};
  const std::vector<Vec2> nodes = follow.nodes(moves);
  int num_moved = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (std::abs(norm(mesh.nodes[i]) - 1) < 1e-9) {
      EXPECT_NEAR(norm(nodes[i]), 1, 1e-12) << "on the circle";
      EXPECT_NEAR(distance(nodes[i], mesh.nodes[i]), 2 * std::sin(0.025), 1e-9);
      ++num_moved;
    }
  EXPECT_GT(num_moved, 20);
}

/// The unit square in 4 x 4 elements: 25 vertices, 9 of them inside.
QuadMesh square_mesh_of(int order) {
  Report report;
  return refine(block::extract_blocks(hand_made::unit_square(), report), {0.25, order, 5e-7}, report);
}

Vec2 place(const RelaxProblem& problem, int vertex) {
  for (int elem = 0; elem < problem.start.num_elems(); ++elem)
    for (int k = 0; k < 4; ++k)
      if (problem.follow.elem_vertices()[elem][k] == vertex) {
        const int n = problem.start.order, width = n + 1;
        const std::array<int, 4> local{0, n, width * width - 1, n * width};
        return problem.start.nodes[problem.start.elem_nodes[elem * width * width + local[k]]];
      }
  return {};
}

TEST(RelaxProblem, OnlyCornersOfTheFaceAreFixed) {
  const RelaxProblem problem(square_mesh_of(3), {});
  ASSERT_EQ(problem.num_vertices(), 25);
  for (int v = 0; v < 25; ++v) {
    const Vec2 x = place(problem, v);
    const bool is_corner = (x.x == 0 || x.x == 1) && (x.y == 0 || x.y == 1);
    EXPECT_EQ(problem.is_fixed[v], is_corner) << x.x << ", " << x.y;
  }
}

TEST(RelaxProblem, FrozenElementsFixTheirVertices) {
  const QuadMesh mesh = square_mesh_of(2);
  std::vector<bool> frozen(16, false);
  frozen[5] = true;
  const RelaxProblem problem(mesh, frozen);
  EXPECT_EQ(std::count(problem.is_fixed.begin(), problem.is_fixed.end(), true), 4 + 4);
  for (const int v : problem.follow.elem_vertices()[5]) EXPECT_TRUE(problem.is_fixed[v]);
}

TEST(RelaxProblem, KeepsACopyOfTheMesh) {
  QuadMesh mesh = square_mesh_of(2);
  const RelaxProblem problem(mesh, {});
  const std::vector<Vec2> before = mesh.nodes;
  for (Vec2& x : mesh.nodes) x = {7, 7};
  EXPECT_EQ(problem.start.nodes, before);
}

}  // namespace
}  // namespace quadrille::refine
