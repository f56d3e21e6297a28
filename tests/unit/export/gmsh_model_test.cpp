#include "export/gmsh_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "two_quads.hpp"

namespace quadrille::exports {

namespace {

using TwoQuadsModel = TwoQuadsTest<gmsh_model>;

TEST_F(TwoQuadsModel, ANodeBelongsToTheEntityOfLowestDimension) {
  // Curves meet at six points and have one node between each two; each quad has one node inside.
  EXPECT_EQ(model.entity_nodes[0].size(), 6u);
  EXPECT_EQ(model.entity_nodes[1].size(), 7u);
  for (const auto& nodes : model.entity_nodes[0]) EXPECT_EQ(nodes.size(), 1u);
  for (const auto& nodes : model.entity_nodes[1]) EXPECT_EQ(nodes.size(), 1u);
  EXPECT_EQ(model.entity_nodes[2], (std::vector<std::vector<int>>{{6}, {8}}));
}

TEST_F(TwoQuadsModel, TagsCountThroughTheEntitiesFromOne) {
  std::vector<int> tags = model.node_tags;
  EXPECT_EQ(tags[model.entity_nodes[0][0][0]], 1);
  EXPECT_EQ(tags[6], 14);
  EXPECT_EQ(tags[8], 15);
  std::sort(tags.begin(), tags.end());
  for (int k = 0; k < 15; ++k) EXPECT_EQ(tags[k], k + 1);
}

TEST_F(TwoQuadsModel, GroupsCountTheBoundariesFirst) {
  EXPECT_EQ(model.boundary_group(0), 1);
  EXPECT_EQ(model.boundary_group(1), 2);
  EXPECT_EQ(model.boundary_group(2), 1) << "of the same name as curve 0";
  EXPECT_EQ(model.boundary_group(3), 3);
  EXPECT_EQ(model.region_group(0), 4);
  EXPECT_EQ(model.region_group(1), 5);
  EXPECT_EQ(model.block_elems, (std::vector<std::vector<int>>{{0}, {1}}));
}

TEST_F(TwoQuadsModel, LinesAndQuadsHaveTheirCornersFirst) {
  std::string line, quad;
  append_gmsh_line(model, mesh, {1, 2}, line);
  append_gmsh_quad(model, mesh, 1, quad);
  const auto tags = [&](const std::vector<int>& nodes) {
    std::string text;
    for (const int node : nodes) text.append(" ").append(std::to_string(model.node_tags[node]));
    return text.append("\n");
  };
  EXPECT_EQ(line, tags({14, 12, 13}));
  EXPECT_EQ(quad, tags({2, 4, 14, 12, 3, 9, 13, 7, 8}));
}

TEST(GmshModel, TheSequenceOfEachOrderIsAPermutationFromOutsideToInside) {
  for (int order = 1; order <= 10; ++order) {
    QuadMesh mesh = order == 1 ? two_straight_quads() : two_quads();
    if (order > 2) {
      mesh.order = order;
      const int width = order + 1;
      mesh.nodes.clear(), mesh.elem_nodes.clear();
      for (int k = 0; k < width * width; ++k) {
        mesh.nodes.push_back({1.0 * (k % width), 1.0 * (k / width)});
        mesh.elem_nodes.push_back(k);
      }
      mesh.elem_block = {0};
      mesh.block_names = {"left"};
      mesh.boundary_edges = {{0, 0, 0}, {0, 1, 1}, {0, 2, 2}, {0, 3, 3}};
    }
    const std::vector<int> sequence = gmsh_model(mesh, plane_frame(mesh.face)).quad_node_order;
    const int width = order + 1;
    ASSERT_EQ(static_cast<int>(sequence.size()), width * width);
    EXPECT_EQ(std::set<int>(sequence.begin(), sequence.end()).size(), sequence.size());
    int last = 0;  // rings about the middle, from the outermost
    for (const int local : sequence) {
      const int i = local % width, j = local / width, ring = std::min({i, j, order - i, order - j});
      EXPECT_GE(ring, last);
      last = ring;
    }
  }
}

TEST(GmshModel, NamesAreQuotedAndCountedThrough) {
  Groups groups;
  groups.boundary_names = {"wall", "a \"b\"\n"};
  groups.region_names = {"fluid"};
  EXPECT_EQ(gmsh_names(groups), "$PhysicalNames\n3\n1 1 \"wall\"\n1 2 \"a 'b' \"\n2 3 \"fluid\"\n$EndPhysicalNames\n");
}

TEST(GmshModel, PositionsReadBackToTheSameBits) {
  std::string text;
  append_position({0.1, 1.0 / 3, -2}, text);
  EXPECT_EQ(text, "0.1 0.3333333333333333 -2");
}

TEST(GmshModel, PositionsLieInTheFrame) {
  const QuadMesh mesh = two_quads();
  EXPECT_EQ(gmsh_model(mesh, upright_frame()).positions[6], (std::array<double, 3>{7, 1, 1}));
}

}  // namespace

}  // namespace quadrille::exports
