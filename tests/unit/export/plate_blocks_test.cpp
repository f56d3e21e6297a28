#include "export/plate_blocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "../hand_made.hpp"
#include "../support/refined.hpp"
#include "base/error.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

TEST(PlateBlocks, ABlockThatBlockMeshCanBuildStaysWhole) {
  const QuadMesh mesh = refined(hand_made::unit_square(), {0.2, 3});
  const PlateBlocks plates = plate_blocks(mesh, mesh_groups(mesh));
  ASSERT_EQ(plates.blocks.size(), 1u);
  EXPECT_EQ(plates.vertices.size(), 4u);
  EXPECT_EQ(plates.blocks[0].edges[0].num_cells() * plates.blocks[0].edges[1].num_cells(), mesh.num_elems());
  EXPECT_TRUE(plates.splines.empty()) << "straight";
  EXPECT_EQ(plates.patches, (std::vector<std::vector<std::array<int, 2>>>{{{0, 1}}, {{1, 2}}, {{2, 3}}, {{3, 0}}}));
  EXPECT_NEAR(plates.moved, 0, 1e-12);
}

TEST(PlateBlocks, ACurvedSideIsASplineThroughItsVertices) {
  const QuadMesh mesh = refined(hand_made::quarter_annulus(), {0.3, 4});
  const PlateBlocks plates = plate_blocks(mesh, mesh_groups(mesh));
  ASSERT_EQ(plates.blocks.size(), 1u);
  ASSERT_EQ(plates.splines.size(), 2u);
  std::set<double> radii;
  for (const PlateSpline& spline : plates.splines) {
    const double radius = norm(mesh.nodes[plates.vertices[spline.from]]);
    for (const Vec2 x : spline.inner) EXPECT_NEAR(norm(x), radius, 1e-4);
    radii.insert(std::round(radius));
  }
  EXPECT_EQ(radii, (std::set<double>{1, 2}));
  EXPECT_LT(plates.moved, 0.03);
}

TEST(PlateBlocks, CornersAreCounterClockwiseAndPatchesHaveTheDomainOnTheirLeft) {
  const QuadMesh mesh = refined(hand_made::l_shape(), {0.5, 2});
  const PlateBlocks plates = plate_blocks(mesh, mesh_groups(mesh));
  const auto at = [&](int vertex) { return mesh.nodes[plates.vertices[vertex]]; };
  ASSERT_EQ(plates.blocks.size(), 3u);
  std::set<std::array<int, 2>> sides;
  for (const PlateBlock& block : plates.blocks)
    for (int k = 0; k < 4; ++k) {
      const int from = block.corners[k], to = block.corners[(k + 1) % 4];
      EXPECT_GT(cross(at(to) - at(from), at(block.corners[(k + 2) % 4]) - at(to)), 0);
      EXPECT_TRUE(sides.insert({from, to}).second);
    }
  std::size_t num_patch_sides = 0;
  for (const auto& patch : plates.patches)
    for (const std::array<int, 2>& side : patch) {
      ++num_patch_sides;
      EXPECT_TRUE(sides.contains(side));
      EXPECT_FALSE(sides.contains({side[1], side[0]}));
    }
  EXPECT_EQ(num_patch_sides, 8u);
}

TEST(PlateBlocks, NamesThatEndWithinASideCutBlocks) {
  refine::RefineOptions options{0.3, 3};
  options.relax = refine::Relax::none;  // blockMesh could not place relaxed vertices in so few blocks
  const QuadMesh mesh = refined(hand_made::elbow(), options);
  const PlateBlocks plates = plate_blocks(mesh, mesh_groups(mesh));
  EXPECT_EQ(plates.blocks.size(), 2u);
  ASSERT_EQ(plates.patches.size(), 6u);
  for (const auto& patch : plates.patches) EXPECT_EQ(patch.size(), 1u);
}

TEST(PlateBlocks, RingsAreCutUntilSidesHaveEndsOfTheirOwn) {
  for (const int cuts : {1, 2}) {
    const QuadMesh mesh = refined(hand_made::cut_annulus(cuts), {0.2, 3});
    const PlateBlocks plates = plate_blocks(mesh, mesh_groups(mesh));
    EXPECT_GE(plates.blocks.size(), 3u);
    std::size_t on_boundary = 0;
    for (const auto& patch : plates.patches) on_boundary += patch.size();
    EXPECT_GE(on_boundary, 6u);
    int cells = 0;
    for (const PlateBlock& block : plates.blocks) cells += block.edges[0].num_cells() * block.edges[1].num_cells();
    EXPECT_EQ(cells, mesh.num_elems());
  }
}

/// A square with a hole in the shape of an eye: the blocks above and below it have sides with the same ends.
SeparatrixGraph square_with_eye() {
  SeparatrixGraph g;
  const std::vector<Vec2> outline{{-2, -2}, {-1, -2}, {1, -2}, {2, -2}, {2, 0},
                                  {2, 2},   {1, 2},   {-1, 2}, {-2, 2}, {-2, 0}};
  std::vector<Nurbs> loop;
  for (std::size_t i = 0; i < outline.size(); ++i) loop.push_back(curve::segment(outline[i], outline[(i + 1) % 10]));
  const Nurbs lid{2, {0, 0, 0, 1, 1, 1}, {{-1, 0}, {0, 0.4}, {1, 0}}, {1, 1, 1}};
  const Nurbs lower{2, {0, 0, 0, 1, 1, 1}, {{1, 0}, {0, -0.4}, {-1, 0}}, {1, 1, 1}};
  g.face = hand_made::face({loop, {lid, lower}}, std::sqrt(32.0));
  for (int i = 0; i < 10; ++i) hand_made::add_joint_node(g, i, i % 5 == 0 || i % 5 == 3 ? 1 : 2);
  for (int i = 0; i < 10; ++i) hand_made::add_arc(g, i, (i + 1) % 10, true, {hand_made::whole(g, i)});
  const int left = hand_made::add_joint_node(g, 10, 4), right = hand_made::add_joint_node(g, 11, 4);
  hand_made::add_arc(g, left, right, true, {hand_made::whole(g, 10)});
  hand_made::add_arc(g, right, left, true, {hand_made::whole(g, 11)});
  for (const int end : {1, 9, 7}) hand_made::add_cut(g, left, end);
  for (const int end : {2, 4, 6}) hand_made::add_cut(g, right, end);
  return g;
}

TEST(PlateBlocks, BlocksOnBothSidesOfAHoleAreCutIfTheirSidesHaveTheSameEnds) {
  const QuadMesh mesh = refined(square_with_eye(), {0.5, 3});
  const PlateBlocks plates = plate_blocks(mesh, mesh_groups(mesh));
  EXPECT_GT(plates.blocks.size(), 6u);
  std::set<std::array<int, 2>> ends;
  for (const auto& patch : plates.patches)
    for (const auto& [a, b] : patch) EXPECT_TRUE(ends.insert({std::min(a, b), std::max(a, b)}).second);
}

TEST(PlateBlocks, RefusesSidesOfQuadsWithTheSameEnds) {
  const QuadMesh mesh = ring_of_two_quads();
  EXPECT_THROW(plate_blocks(mesh, mesh_groups(mesh)), ComputeError);
}

TEST(PlateBlocks, RefusesCellsThatAreNotConvex) {
  QuadMesh mesh = two_straight_quads();
  mesh.nodes[4] = {3.5, 0.5};
  mesh.nodes[5] = {4, 3};
  EXPECT_NO_THROW(plate_blocks(two_straight_quads(), mesh_groups(two_straight_quads())));
  EXPECT_THROW(plate_blocks(mesh, mesh_groups(mesh)), ComputeError);
}

/// Two strips of two quads, [0, 1] x [0, 2] and [5, 6] x [0, 2]. The left side of the first one (curve 0) is the right
/// side of the second one (curve 1) moved by -6; the right side of the first one has two names.
QuadMesh two_strips() {
  QuadMesh mesh;
  mesh.order = 1;
  mesh.face.diameter = 6;
  mesh.face.curves.resize(5);
  mesh.face.curve_names = {"left", "right", "lower", "upper", "rest"};
  for (const double x : {0.0, 5.0})
    for (const double y : {0.0, 1.0, 2.0})
      for (const double width : {0.0, 1.0}) mesh.nodes.push_back({x + width, y});
  for (const int first : {0, 2, 6, 8})
    for (const int k : {0, 1, 2, 3}) mesh.elem_nodes.push_back(first + k);
  mesh.elem_block = {0, 0, 1, 1};
  mesh.block_names = {"", ""};
  mesh.elem_jacobian_bound = mesh.elem_scaled_jacobian = std::vector<double>(4, 0.5);
  mesh.boundary_edges = {{1, 3, 0}, {0, 3, 0}, {2, 1, 1}, {3, 1, 1}, {0, 1, 2}, {1, 1, 3},
                         {0, 0, 4}, {1, 2, 4}, {2, 0, 4}, {3, 2, 4}, {2, 3, 4}, {3, 3, 4}};
  return mesh;
}

TEST(PlateBlocks, ACutContinuesAcrossPeriodicSides) {
  QuadMesh mesh = two_strips();
  EXPECT_EQ(plate_blocks(mesh, mesh_groups(mesh)).blocks.size(), 3u);
  mesh.face.periodic_pairs = {{{1, 0}, 0, {-6, 0}}};
  EXPECT_EQ(plate_blocks(mesh, mesh_groups(mesh)).blocks.size(), 4u);
}

}  // namespace
}  // namespace quadrille::exports
