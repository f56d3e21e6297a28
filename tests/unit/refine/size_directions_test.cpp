#include <gtest/gtest.h>

#include <cmath>

#include "../hand_made.hpp"
#include "../support/refined.hpp"
#include "refine/size_energy.hpp"

namespace quadrille::refine {
namespace {

/// 4 x 4 squares of order 1 in the unit square.
struct SizeDirections : testing::Test {
  QuadMesh mesh =
      refined(hand_made::unit_square(), {.size = 0.25, .order = 1, .geometry_tol = 1e-3, .relax = Relax::none});
  RelaxProblem problem{mesh, {}};
  SizeEnergy energy{problem, mesh};
  VertexMoves none = VertexMoves(problem.num_vertices());

  std::vector<Vec2> equal_sizes() const { return std::vector<Vec2>(mesh.num_elems(), Vec2{0.25, 0.25}); }
  /// An inner vertex is moved.
  VertexMoves one_moved(Vec2 move) {
    VertexMoves moves = none;
    const std::vector<Vec2>& positions = energy.positions(none);
    for (int v = 0; v < problem.num_vertices(); ++v)
      if (distance(positions[v], {0.5, 0.5}) < 1e-9) moves[v] = move;
    return moves;
  }
};

TEST_F(SizeDirections, MiddlesAreTheMeansOfTheVertices) {
  const std::vector<Vec2> at_first = energy.middles(none), moved = energy.middles(one_moved({0.04, 0.08}));
  int num_moved = 0;
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    EXPECT_NEAR(std::remainder(at_first[elem].x - 0.125, 0.25), 0, 1e-12);
    if (moved[elem] == at_first[elem]) continue;
    EXPECT_LT(distance(moved[elem] - at_first[elem], {0.01, 0.02}), 1e-12);
    ++num_moved;
  }
  EXPECT_EQ(num_moved, 4);
}

/// Elements that stand for several have as much of the area to fill.
TEST_F(SizeDirections, SizesAreScaledBySoManyElementsAsEachStandsFor) {
  energy.set_sizes(equal_sizes());
  const double plain = energy.value(none);
  energy.multiplicities.assign(mesh.num_elems(), 4);
  energy.set_sizes(equal_sizes());
  EXPECT_NEAR(energy.value(none), 4 * plain, 1e-9);
}

/// Sizes that grow to the right are those at first where the elements are at first.
TEST_F(SizeDirections, SizesThatGrowFollowTheMiddles) {
  const VertexMoves moves = one_moved({0.04, 0});
  energy.set_sizes(equal_sizes());
  const double moved = energy.value(moves), at_first = energy.value(none);
  energy.set_sizes(equal_sizes(), std::vector<Vec2>(mesh.num_elems(), Vec2{2, 0}));
  EXPECT_NEAR(energy.value(none), at_first, 1e-12);
  EXPECT_GT(std::abs(energy.value(moves) - moved), 1e-3);
  energy.positions(none);
  energy.set_sizes(equal_sizes(), std::vector<Vec2>(mesh.num_elems(), Vec2{0, 2}));
  EXPECT_NEAR(energy.value(moves), moved, 1e-12) << "the middles move along x";
}

TEST_F(SizeDirections, StraightSidesDoNotShortenSizes) {
  energy.positions(none);
  for (int elem = 0; elem < mesh.num_elems(); ++elem) EXPECT_EQ(energy.bend_factors(elem, 0.25), (Vec2{1, 1}));
}

/// By -c / |c| the cross is turned by 45 degrees: each of the two sides adds 2 |c|.
TEST_F(SizeDirections, DirectionsOfOneElementAddToItAlone) {
  energy.set_sizes(equal_sizes());
  const double plain = energy.value(none);
  energy.directions.assign(mesh.num_elems(), {});
  energy.directions[5] = {3, 0};
  EXPECT_NEAR(energy.value(none), plain, 1e-12);
  energy.directions[5] = {-3, 0};
  EXPECT_NEAR(energy.value(none), plain + 4 * 3, 1e-9);
  energy.multiplicities[5] = 2;
  const double doubled = energy.value(none);
  energy.directions[5] = {};
  EXPECT_NEAR(doubled, energy.value(none) + 2 * 4 * 3, 1e-9);
}

}  // namespace
}  // namespace quadrille::refine
