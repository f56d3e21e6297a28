#include "refine/split_isoparametric.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "../hand_made.hpp"
#include "../support/block_sides.hpp"
#include "block/extract_blocks.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::refine {
namespace {

/// A layout with an empty mesh that begins with its nodes.
struct Sample {
  Sample(const SeparatrixGraph& graph, int order) : layout(blocks_of(graph)), measured(layout) {
    mesh.order = order;
    for (const GraphNode& node : layout.nodes) mesh.nodes.push_back(node.position);
  }
  static BlockLayout blocks_of(const SeparatrixGraph& graph) {
    Report report;
    return block::extract_blocks(graph, report);
  }
  int num_corners() const { return static_cast<int>(layout.nodes.size()); }

  BlockLayout layout;
  sizing::MeasuredLayout measured;
  QuadMesh mesh;
};

sizing::ArcDivision division(const std::vector<double>& ends) {
  sizing::ArcDivision d;
  d.ends = ends;
  return d;
}

TEST(ArcNodes, AreTheGaussLobattoPointsOfEachInterval) {
  Sample s(hand_made::unit_square(), 3);
  const ArcNodes nodes = place_on_arc(s.measured, 0, division({0, 0.25, 1}), nullptr, s.mesh);
  const double inner = 1 / std::sqrt(5.0);  // the points of order 3
  const std::vector<double> expected{
      0, 0.125 - 0.125 * inner, 0.125 + 0.125 * inner, 0.25, 0.625 - 0.375 * inner, 0.625 + 0.375 * inner, 1};
  ASSERT_EQ(nodes.fractions.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(nodes.fractions[k], expected[k], 1e-15);
  EXPECT_EQ(nodes.ids, (std::vector<int>{s.layout.arcs[0].from, 4, 5, 6, 7, 8, s.layout.arcs[0].to}));
  for (std::size_t k = 1; k + 1 < expected.size(); ++k)
    EXPECT_NEAR(distance(s.mesh.nodes[nodes.ids[k]], {expected[k], 0}), 0, 1e-14);
}

TEST(ArcNodes, LieAtFractionsOfTheArcLengthOfACurve) {
  Sample s(hand_made::quarter_annulus(), 1);
  const ArcNodes nodes = place_on_arc(s.measured, 1, division({0, 1.0 / 3, 1}), nullptr, s.mesh);
  ASSERT_EQ(nodes.ids.size(), 3u);
  EXPECT_NEAR(distance(s.mesh.nodes[nodes.ids[1]], 2 * unit(pi / 6)), 0, 1e-12);
  EXPECT_EQ(static_cast<int>(s.mesh.nodes.size()), s.num_corners() + 1);
}

TEST(ArcNodes, OfOneIntervalOfOrderOneAreTheEndsOfTheArc) {
  Sample s(hand_made::unit_square(), 1);
  const ArcNodes nodes = place_on_arc(s.measured, 2, division({0, 1}), nullptr, s.mesh);
  EXPECT_EQ(nodes.ids, (std::vector<int>{s.layout.arcs[2].from, s.layout.arcs[2].to}));
  EXPECT_EQ(static_cast<int>(s.mesh.nodes.size()), s.num_corners());
}

TEST(ArcNodes, LayersPrescribeTheirOwnNodes) {
  Sample s(hand_made::unit_square(), 2);
  layers::WallPlan walls;
  walls.arc_nodes.resize(4);
  walls.arc_nodes[1] = {0, 0.01, 0.03, 0.5, 1};
  const ArcNodes layered = place_on_arc(s.measured, 1, division({0, 0.03, 1}), &walls, s.mesh);
  EXPECT_EQ(layered.fractions, walls.arc_nodes[1]);
  const ArcNodes free = place_on_arc(s.measured, 0, division({0, 1}), &walls, s.mesh);
  EXPECT_EQ(free.fractions, (std::vector<double>{0, 0.5, 1}));
}

TEST(SideNodes, RunInTheDirectionOfTheBlocksCoordinates) {
  // Sides 0 and 2 from left to right, 1 and 3 upwards, whatever the directions of their arcs.
  Sample s(hand_made::unit_square(), 1);
  std::vector<ArcNodes> arcs;
  for (int a = 0; a < 4; ++a) arcs.push_back(place_on_arc(s.measured, a, division({0, 0.2, 1}), nullptr, s.mesh));
  const std::array<ArcNodes, 4> sides = side_nodes(s.layout, 0, arcs);
  for (int k = 0; k < 4; ++k) {
    ASSERT_EQ(sides[k].ids.size(), 3u);
    const auto at = [&](int i) {
      const Vec2 x = s.mesh.nodes[sides[k].ids[i]];
      return k % 2 == 0 ? x.x : x.y;
    };
    EXPECT_LT(at(0), at(1));
    EXPECT_LT(at(1), at(2));
    EXPECT_NEAR(sides[k].fractions[1], k < 2 ? 0.2 : 0.8, 1e-15) << "the upper and the left arc run backwards";
  }
  EXPECT_EQ(sides[0].ids.front(), sides[3].ids.front());
  EXPECT_EQ(sides[1].ids.back(), sides[2].ids.back());
}

TEST(SideNodes, NeighboursShareTheNodesOfTheirArc) {
  Sample s(hand_made::l_shape(), 2);
  std::vector<ArcNodes> arcs;
  for (int a = 0; a < static_cast<int>(s.layout.arcs.size()); ++a)
    arcs.push_back(place_on_arc(s.measured, a, division({0, 0.3, 1}), nullptr, s.mesh));
  std::vector<int> uses(s.mesh.nodes.size(), 0);
  for (int b = 0; b < s.layout.num_blocks(); ++b)
    for (const ArcNodes& side : side_nodes(s.layout, b, arcs))
      for (std::size_t k = 1; k + 1 < side.ids.size(); ++k) ++uses[side.ids[k]];
  for (std::size_t a = 0; a < arcs.size(); ++a)
    for (std::size_t k = 1; k + 1 < arcs[a].ids.size(); ++k)
      EXPECT_EQ(uses[arcs[a].ids[k]], s.layout.arcs[a].is_boundary ? 1 : 2);
}

BlockLayout layout_of(const SeparatrixGraph& graph) {
  Report report;
  return block::extract_blocks(graph, report);
}

/// The same number of equal elements on every arc.
sizing::ArcDivisions equal_divisions(const BlockLayout& layout, int count) {
  sizing::ArcDivision division{{0}};
  for (int k = 1; k <= count; ++k) division.ends.push_back(static_cast<double>(k) / count);
  return sizing::ArcDivisions(layout.arcs.size(), division);
}

QuadMesh split(const BlockLayout& layout, int count, int order) {
  return split_isoparametric(sizing::MeasuredLayout(layout), equal_divisions(layout, count), order);
}

TEST(SplitIsoparametric, SharesTheNodesOfArcsBetweenBlocks) {
  const BlockLayout layout = layout_of(hand_made::l_shape());
  for (const int order : {1, 3}) {
    const QuadMesh mesh = split(layout, 2, order);
    EXPECT_EQ(mesh.num_elems(), 3 * 4);
    const int width = 2 * order + 1;
    EXPECT_EQ(mesh.nodes.size(), static_cast<std::size_t>(3 * width * width - 2 * width));
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) EXPECT_GT(distance(mesh.nodes[i], mesh.nodes[k]), 1e-6);
  }
}

TEST(SplitIsoparametric, BeginsWithTheNodesOfTheLayout) {
  const BlockLayout layout = layout_of(hand_made::cut_annulus(3));
  const QuadMesh mesh = split(layout, 3, 2);
  for (std::size_t i = 0; i < layout.nodes.size(); ++i) EXPECT_EQ(mesh.nodes[i], layout.nodes[i].position);
}

TEST(SplitIsoparametric, ElementsLieAlongSideZeroFirst) {
  const BlockLayout layout = layout_of(hand_made::unit_square());
  sizing::ArcDivisions divisions = equal_divisions(layout, 2);
  for (const int side : {1, 3}) divisions[layout.block2arcs[0][side].arc] = {{0, 1.0 / 3, 2.0 / 3, 1}};
  const QuadMesh mesh = split_isoparametric(sizing::MeasuredLayout(layout), divisions, 1);
  ASSERT_EQ(mesh.num_elems(), 6);
  const Vec2 start = mesh.nodes[layout.block2nodes[0][0]], next = mesh.nodes[layout.block2nodes[0][1]];
  EXPECT_EQ(mesh.nodes[mesh.elem_nodes[0]], start);
  EXPECT_NEAR(distance(mesh.nodes[mesh.elem_nodes[4]], (start + next) / 2), 0, 1e-15) << "element 1 is beside 0";
  for (int elem = 0; elem < 6; ++elem) {
    const int* n = &mesh.elem_nodes[elem * 4];
    EXPECT_NEAR(cross(mesh.nodes[n[1]] - mesh.nodes[n[0]], mesh.nodes[n[2]] - mesh.nodes[n[0]]), 1.0 / 6, 1e-12);
  }
}

TEST(SplitIsoparametric, BoundaryEdgesFollowTheLoopsInOrder) {
  const BlockLayout layout = layout_of(hand_made::cut_annulus(4));
  const QuadMesh mesh = split(layout, 3, 2);
  ASSERT_EQ(mesh.boundary_edges.size(), 24u);
  const int width = mesh.order + 1;
  const std::array<int, 4> corner{0, width - 1, width * width - 1, width * (width - 1)};
  const auto node = [&](const QuadBoundaryEdge& e, int end) {
    return mesh.elem_nodes[e.elem * width * width + corner[(e.side + end) % 4]];
  };
  for (std::size_t i = 0; i < 24; ++i) {
    EXPECT_EQ(mesh.boundary_edges[i].curve, i < 12 ? 0 : 1);
    const std::size_t next = i % 12 == 11 ? i - 11 : i + 1;
    EXPECT_EQ(node(mesh.boundary_edges[i], 1), node(mesh.boundary_edges[next], 0)) << i;
  }
}

TEST(SplitIsoparametric, InnerNodesLieOnTheBlendOfTheSides) {
  // A ring of one block: the map is (r, angle), and its lines are circles and radii.
  const BlockLayout layout = layout_of(hand_made::quarter_annulus());
  const QuadMesh mesh = split(layout, 2, 2);
  for (const Vec2 x : mesh.nodes) {
    const double r = 4 * (norm(x) - 1), angle = 4 * std::atan2(x.y, x.x) / half_pi;
    EXPECT_NEAR(r, std::round(r), 1e-9);
    EXPECT_NEAR(angle, std::round(angle), 1e-9);
  }
}

TEST(SplitIsoparametric, IrregularNodesInsideAreCounted) {
  BlockLayout layout = layout_of(hand_made::l_shape());
  EXPECT_EQ(split(layout, 1, 1).num_irregular, 0) << "the reflex corner lies on the boundary";
  layout.nodes[0].curve = -1;
  layout.nodes[0].valence = 3;
  EXPECT_EQ(split(layout, 1, 1).num_irregular, 1);
}

}  // namespace
}  // namespace quadrille::refine
