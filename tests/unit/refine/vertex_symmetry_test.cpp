#include "refine/vertex_symmetry.hpp"

#include <gtest/gtest.h>

#include "../hand_made.hpp"
#include "../support/refined.hpp"

namespace quadrille::refine {
namespace {

/// Equal squares that fill the unit square, whose vertices slide along its sides.
struct SymmetricSquare : testing::Test {
  QuadMesh mesh =
      refined(hand_made::unit_square(), {.size = 0.25, .order = 1, .geometry_tol = 1e-3, .relax = Relax::none});
  RelaxProblem problem{mesh, {}};
  std::vector<Vec2> positions = std::vector<Vec2>(problem.num_vertices()), tangents;

  SymmetricSquare() {
    for (int elem = 0; elem < mesh.num_elems(); ++elem)
      for (int k = 0; k < 4; ++k)
        positions[problem.follow.elem_vertices()[elem][k]] = mesh.nodes[side_start(mesh, elem, k)];
    for (const Vec2 x : positions)
      tangents.push_back(x.y == 0 ? Vec2{1, 0} : x.y == 1 ? Vec2{-1, 0} : x.x == 1 ? Vec2{0, 1} : Vec2{0, -1});
  }
  /// Each vertex moves towards the middle; those on the sides along them, the corners not at all.
  VertexMoves inwards() const {
    VertexMoves moves;
    for (int v = 0; v < problem.num_vertices(); ++v) {
      const Vec2 x = positions[v], inward = Vec2{0.5, 0.5} - x;
      const bool is_corner = (x.x == 0 || x.x == 1) && (x.y == 0 || x.y == 1);
      moves.push_back(is_corner                            ? Vec2{}
                      : problem.follow.on_boundary(v) >= 0 ? Vec2{dot(inward, tangents[v]), 0}
                                                           : inward);
    }
    return moves;
  }
  int vertex_at(Vec2 x) const {
    for (int v = 0; v < problem.num_vertices(); ++v)
      if (distance(positions[v], x) < 1e-9) return v;
    ADD_FAILURE() << "no vertex at " << x.x << ", " << x.y;
    return 0;
  }
  VertexMoves averaged(VertexMoves moves, const VertexMoves& gradient) const {
    VertexSymmetry(problem, positions, tangents, gradient).average(moves);
    return moves;
  }
};
using VertexSymmetryOfASquare = SymmetricSquare;

TEST_F(VertexSymmetryOfASquare, SymmetricMovesStay) {
  const VertexMoves moves = inwards(), same = averaged(moves, moves);
  for (std::size_t v = 0; v < moves.size(); ++v) EXPECT_LT(distance(moves[v], same[v]), 1e-15);
}

/// The square has eight isometries: of the move of one vertex an eighth remains, and as much is at its images.
TEST_F(VertexSymmetryOfASquare, AMoveIsSharedAmongTheImages) {
  VertexMoves one(problem.num_vertices());
  one[vertex_at({0.25, 0.5})] = {0.8, 0.4};  // two isometries keep it
  const VertexMoves mean = averaged(one, inwards());
  EXPECT_LT(distance(mean[vertex_at({0.25, 0.5})], {0.2, 0}), 1e-15);
  EXPECT_LT(distance(mean[vertex_at({0.5, 0.25})], {0, 0.2}), 1e-15);
  EXPECT_LT(distance(mean[vertex_at({0.75, 0.5})], {-0.2, 0}), 1e-15);
  EXPECT_EQ(mean[vertex_at({0.25, 0.25})], (Vec2{}));
}

TEST_F(VertexSymmetryOfASquare, SlidesOfMirrorImagesAreOpposite) {
  VertexMoves one(problem.num_vertices());
  one[vertex_at({0.25, 0})] = {0.8, 0};
  const VertexMoves mean = averaged(one, inwards());
  EXPECT_NEAR(mean[vertex_at({0.25, 0})].x, 0.1, 1e-15);
  EXPECT_NEAR(mean[vertex_at({0.75, 0})].x, -0.1, 1e-15);
  EXPECT_NEAR(mean[vertex_at({1, 0.25})].x, 0.1, 1e-15);
  EXPECT_NEAR(mean[vertex_at({0.5, 0})].x, 0, 1e-15);
}

/// A gradient that points to the right everywhere is that of the reflection at y = 1/2 alone.
TEST_F(VertexSymmetryOfASquare, OnlySymmetriesOfTheGradientCount) {
  VertexMoves gradient(problem.num_vertices());
  for (int v = 0; v < problem.num_vertices(); ++v)
    gradient[v] = problem.follow.on_boundary(v) >= 0 ? Vec2{tangents[v].x, 0} : Vec2{1, 0};
  VertexMoves one(problem.num_vertices());
  one[vertex_at({0.25, 0.25})] = {0.8, 0.4};
  const VertexMoves mean = averaged(one, gradient);
  EXPECT_LT(distance(mean[vertex_at({0.25, 0.25})], {0.4, 0.2}), 1e-15);
  EXPECT_LT(distance(mean[vertex_at({0.25, 0.75})], {0.4, -0.2}), 1e-15);
  EXPECT_EQ(mean[vertex_at({0.75, 0.25})], (Vec2{}));
}

TEST_F(VertexSymmetryOfASquare, AVertexInAnotherPlaceEndsTheSymmetry) {
  const VertexMoves gradient = inwards();
  positions[vertex_at({0.25, 0.5})].x += 1e-4;
  VertexMoves one(problem.num_vertices());
  one[vertex_at({0.25, 0.25})] = {0.8, 0.4};
  const VertexMoves mean = averaged(one, gradient);
  EXPECT_LT(distance(mean[vertex_at({0.25, 0.75})], {0.4, -0.2}), 1e-15) << "of the reflection at y = 1/2";
  EXPECT_EQ(mean[vertex_at({0.75, 0.25})], (Vec2{}));
}

}  // namespace
}  // namespace quadrille::refine
