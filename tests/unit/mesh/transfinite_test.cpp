#include "mesh/transfinite.hpp"

#include <gtest/gtest.h>

#include "../hand_made.hpp"

namespace quadrille::mesh {

namespace {

struct Block {
  SeparatrixGraph graph;
  curve::CurveTable table{graph.face, graph.splines};
  std::vector<curve::Chain> chains;

  explicit Block(SeparatrixGraph g) : graph(std::move(g)) {
    for (const GraphArc& arc : graph.arcs) chains.emplace_back(table, arc.pieces);
  }
  TransfiniteMap map() const { return TransfiniteMap({&chains[0], &chains[1], &chains[2], &chains[3]}, {}); }
};

TEST(Transfinite, StraightSidesGiveTheBilinearMap) {
  const Block block(hand_made::unit_square());
  for (const double s : {0.1, 0.5, 0.8})
    for (const double t : {0.25, 0.9}) EXPECT_NEAR(distance(block.map().position(s, t), {s, t}), 0, 1e-15);
}

TEST(Transfinite, ConcentricArcsGivePolarCoordinates) {
  const Block block(hand_made::quarter_annulus());
  EXPECT_NEAR(distance(block.map().position(0.3, 0.6), 1.3 * unit(0.6 * half_pi)), 0, 1e-13);
}

TEST(Transfinite, SidesAreReproducedExactly) {
  const Block block(hand_made::elbow());
  const TransfiniteMap map = block.map();
  for (const double f : {0.0, 0.125, 0.4, 0.75, 1.0}) {
    if (f < 1) {
      EXPECT_EQ(map.position(f, 0), block.chains[0].at(f).position);
    }
    EXPECT_EQ(map.position(1, f), f > 0 ? block.chains[1].at(f).position : block.chains[0].at(1).position);
  }
}

TEST(Transfinite, TwoBlocksSeeTheSameSide) {
  // The middle arc bounds the left block forwards and the right one backwards; dyadic fractions mirror exactly.
  SeparatrixGraph g = hand_made::unit_square();
  g.splines.push_back(curve::circular_arc({-1, 0.5}, 1.5, -0.3, 0.3));
  const curve::CurveTable table(g.face, g.splines);
  const curve::Chain shared(table, {{4, -0.3, 0.3}});
  const curve::Chain bottom(table, {{0, 0, 1}}), right(table, {{1, 0, 1}}), top(table, {{2, 0, 1}}),
      left(table, {{3, 0, 1}});
  const TransfiniteMap a({&bottom, &shared, &top, &left}, {});
  const TransfiniteMap b({&bottom, &right, &top, &shared}, {false, false, false, true});
  for (const double t : {0.125, 0.5, 0.8125}) EXPECT_EQ(a.position(1, t), b.position(0, t));
}

TEST(Transfinite, CrossingParametersSolveBothLines) {
  const double f0 = 0.3, f1 = 0.7, f2 = 0.45, f3 = 0.5;
  const Vec2 st = crossing_parameters(f0, f1, f2, f3);
  EXPECT_NEAR(st.x, f0 + st.y * (f2 - f0), 1e-15);
  EXPECT_NEAR(st.y, f3 + st.x * (f1 - f3), 1e-15);
  EXPECT_EQ(crossing_parameters(0.3, 0.6, 0.3, 0.6), (Vec2{0.3, 0.6}));
}

TEST(Transfinite, SampledBlockHoldsItsPositions) {
  const Block block(hand_made::s_bend());
  const std::vector<Vec2> nodes = block.map().sampled(2);
  ASSERT_EQ(nodes.size(), 9u);
  EXPECT_EQ(nodes[4], block.map().position(0.5, 0.5));
  EXPECT_EQ(nodes[5], block.map().position(1, 0.5));
}

/// Also checks the measures of the sampled block.
BlockShape shape_of(const std::vector<Vec2>& corners) {
  std::vector<Nurbs> loop;
  for (int k = 0; k < 4; ++k) loop.push_back(curve::segment(corners[k], corners[(k + 1) % 4]));
  const CadFace face = hand_made::face({loop}, 2);
  const std::vector<Nurbs> none;
  const curve::CurveTable table(face, none);
  std::vector<curve::Chain> chains;
  for (int k = 0; k < 4; ++k)
    chains.emplace_back(table, std::vector<ArcPiece>{{k, face.curves[k].begin(), face.curves[k].end()}});
  const TransfiniteMap map({&chains[0], &chains[1], &chains[2], &chains[3]}, {false, false, false, false});
  BlockShape shape = block_shape(map);
  EXPECT_EQ(scaled_jacobian(map.sampled(block_order)), shape.scaled_jacobian);
  EXPECT_EQ(is_valid_block(map.sampled(block_order)), shape.is_valid());
  return shape;
}

TEST(BlockShape, OfASquareOfSideTwo) {
  const BlockShape shape = shape_of({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  EXPECT_NEAR(shape.jacobian_bound, 1, 1e-9);
  EXPECT_NEAR(shape.scaled_jacobian, 1, 1e-12);
  EXPECT_TRUE(shape.is_valid());
}

TEST(BlockShape, ASlantedBlockHasTheSineOfItsAngle) {
  EXPECT_NEAR(shape_of({{0, 0}, {1, 0}, {2, 1}, {1, 1}}).scaled_jacobian, std::sqrt(0.5), 1e-12);
}

TEST(BlockShape, AFoldedBlockIsWorstWhereItFolds) {
  const BlockShape shape = shape_of({{0, 0}, {1, 0}, {0.1, 0.1}, {0, 1}});
  EXPECT_FALSE(shape.is_valid());
  EXPECT_EQ(shape.scaled_jacobian, -1);
  EXPECT_LT(distance(shape.scaled_jacobian_position, {0.1, 0.1}), 0.3);
}

}  // namespace

}  // namespace quadrille::mesh
