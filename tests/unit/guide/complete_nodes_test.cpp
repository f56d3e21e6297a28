#include "guide/complete_nodes.hpp"

#include <gtest/gtest.h>

#include "../support/square_field.hpp"
#include "base/error.hpp"
#include "base/vec2.hpp"

namespace quadrille::guide {
namespace {

std::vector<Vec2> sorted(std::vector<Vec2> points, double tol) {
  sort_by_position(points, tol, [](Vec2 x) { return x; });
  return points;
}

TEST(SortByPosition, GoesByXThenY) {
  EXPECT_EQ(sorted({{1, 0}, {0, 1}, {0, 0}}, 0), (std::vector<Vec2>{{0, 0}, {0, 1}, {1, 0}}));
}

TEST(SortByPosition, TakesXWithinTheToleranceAsEqual) {
  EXPECT_EQ(sorted({{0, 1}, {1e-9, 0}}, 1e-8), (std::vector<Vec2>{{1e-9, 0}, {0, 1}}));
  EXPECT_EQ(sorted({{0, 1}, {1e-9, 0}}, 1e-10), (std::vector<Vec2>{{0, 1}, {1e-9, 0}}));
}

CriticalPoint node(Vec2 position, NodeSource source) {
  CriticalPoint p;
  p.position = position;
  p.index = 1;
  p.valence = 3;
  p.elem = -1;
  p.source = source;
  return p;
}

TEST(NodesWithoutPosition, AreThoseOfSplitClustersAndLineFields) {
  const CadFace face = square_face({0, 0}, 1);
  CriticalPoints points;
  points.clusters = {{{0.5, 0.5}, 0, 1, {{0.5, 0.5}}, {}}};
  points.critical_points = {node({0.2, 0.2}, NodeSource::zero),    node({0.5, 0.5}, NodeSource::cluster),
                            node({0.7, 0.5}, NodeSource::cluster), node({0.1, 0.1}, NodeSource::line),
                            node({0.1, 0.2}, NodeSource::corner),  node({0.3, 0.2}, NodeSource::feature)};
  EXPECT_EQ(nodes_without_position(face, points), (std::vector<bool>{false, false, true, true, false, false}));
}

struct CompleteNodes : testing::Test {
  Field field = interpolated_field(square_mesh({0, 0}, 1, 2), 1, [](Vec2 x) { return x; });
  field::FieldEvaluator evaluator{field};
};

TEST_F(CompleteNodes, FindsElementsAndSortsByPosition) {
  CriticalPoints points;
  const Vec2 a{0.3, 0.8}, b{0.3 + 1e-9, 0.2};  // b has the larger x only by rounding
  points.critical_points = {node({0.9, 0.1}, NodeSource::corner), node(a, NodeSource::corner),
                            node(b, NodeSource::corner)};
  complete_nodes(evaluator, points);
  EXPECT_EQ(points.critical_points[0].position, b);
  EXPECT_EQ(points.critical_points[1].position, a);
  for (const CriticalPoint& p : points.critical_points) {
    ASSERT_GE(p.elem, 0);
    EXPECT_NEAR(distance(evaluator.sample(p.elem, p.xi).x, p.position), 0, 1e-14);
  }
}

TEST_F(CompleteNodes, KeepsTheElementOfAZeroAndRefusesNodesOutside) {
  CriticalPoints points;
  points.critical_points = {node({0.5, 0.5}, NodeSource::zero)};
  complete_nodes(evaluator, points);
  EXPECT_EQ(points.critical_points[0].elem, -1);
  points.critical_points = {node({1.5, 0.5}, NodeSource::corner)};
  EXPECT_THROW(complete_nodes(evaluator, points), ComputeError);
}

}  // namespace
}  // namespace quadrille::guide
