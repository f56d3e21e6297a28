#include "export/gmsh_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "two_quads.hpp"

namespace quadrille::exports {

namespace {

GmshModel model_of_quads(const QuadMesh& mesh, const Frame& frame) { return gmsh_model(mesh, frame); }

using TwoQuadsModel = TwoQuadsTest<model_of_quads>;

TEST_F(TwoQuadsModel, ANodeBelongsToTheEntityOfLowestDimension) {
  // Curves meet at six points and have one node between each two; each quad has one node inside.
  EXPECT_EQ(model.entities[0].size(), 6u);
  EXPECT_EQ(model.entities[1].size(), 7u);
  for (const GmshEntity& point : model.entities[0]) EXPECT_EQ(point.own_nodes.size(), 1u);
  for (const GmshEntity& curve : model.entities[1]) EXPECT_EQ(curve.own_nodes.size(), 1u);
  EXPECT_EQ(model.entities[2][0].own_nodes, std::vector<int>{6});
  EXPECT_EQ(model.entities[2][1].own_nodes, std::vector<int>{8});
}

TEST_F(TwoQuadsModel, TagsCountThroughTheEntitiesFromOne) {
  std::vector<int> tags = model.node_tags;
  EXPECT_EQ(tags[model.entities[0][0].own_nodes[0]], 1);
  EXPECT_EQ(tags[6], 14);
  EXPECT_EQ(tags[8], 15);
  std::sort(tags.begin(), tags.end());
  for (int k = 0; k < 15; ++k) EXPECT_EQ(tags[k], k + 1);
}

TEST_F(TwoQuadsModel, GroupsCountTheBoundariesFirst) {
  std::map<int, int> num_curves;  // by group; curves 0 and 2 have the same name
  for (const GmshEntity& curve : model.entities[1]) ++num_curves[curve.group];
  EXPECT_EQ(num_curves, (std::map<int, int>{{0, 1}, {1, 4}, {2, 1}, {3, 1}}));
  EXPECT_EQ(model.entities[2][0].group, 4);
  EXPECT_EQ(model.entities[2][1].group, 5);
}

TEST_F(TwoQuadsModel, LinesAndQuadsHaveTheirCornersFirst) {
  EXPECT_EQ(model.node_orders[1], (std::vector<int>{0, 2, 1}));
  EXPECT_EQ(model.node_orders[2], (std::vector<int>{0, 2, 8, 6, 1, 5, 7, 3, 4}));
  EXPECT_EQ(model.entities[2][1].elem_nodes, (std::vector<int>{2, 3, 4, 7, 8, 9, 12, 13, 14}));
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
    const std::vector<int> sequence = gmsh_model(mesh, plane_frame(mesh.face)).node_orders[2];
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
  GmshModel model;
  model.groups.boundary_names = {"wall", "a \"b\"\n"};
  model.groups.region_names = {"fluid"};
  const std::string names = "$PhysicalNames\n3\n1 1 \"wall\"\n1 2 \"a 'b' \"\n2 3 \"fluid\"\n$EndPhysicalNames\n";
  EXPECT_NE(gmsh41_text(model).find(names), std::string::npos);
}

TEST(GmshModel, PositionsReadBackToTheSameBits) {
  GmshModel model;
  model.positions = {{0.1, 1.0 / 3, -2}};
  model.node_tags = {1};
  model.entities[0] = {{0, {}, {0}, {0}}};
  EXPECT_NE(gmsh41_text(model).find("\n1 0.1 0.3333333333333333 -2 0\n"), std::string::npos);
}

TEST(GmshModel, PositionsLieInTheFrame) {
  const QuadMesh mesh = two_quads();
  EXPECT_EQ(gmsh_model(mesh, upright_frame()).positions[6], (std::array<double, 3>{7, 1, 1}));
}

}  // namespace

}  // namespace quadrille::exports
