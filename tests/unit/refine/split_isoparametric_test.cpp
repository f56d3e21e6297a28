#include "refine/split_isoparametric.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "../hand_made.hpp"
#include "block/extract_blocks.hpp"

namespace quadrille::refine {
namespace {

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
