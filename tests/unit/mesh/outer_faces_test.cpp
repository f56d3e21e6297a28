#include "mesh/outer_faces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "../samples.hpp"

namespace quadrille::mesh {
namespace {

TEST(OuterFaces, OfTwoHexahedraAreTenQuads) {
  const HexMesh hexes = samples::hex_mesh();
  const QuadMesh outer = outer_faces(hexes);
  ASSERT_EQ(outer.num_elems(), 10);
  EXPECT_EQ(outer.space_nodes.size(), 12u) << "all nodes lie outside, each once";
  EXPECT_EQ(outer.nodes, std::vector<Vec2>(12));
  EXPECT_EQ(outer.elem_block, (std::vector<int>{0, 1, 1, 1, 0, 0, 0, 1, 0, 1})) << "those of the hexahedra";
  EXPECT_EQ(outer.block_names, (std::vector<std::string>{"domain", "domain"}));
  EXPECT_EQ(outer.face.length_unit, "metre");
  EXPECT_EQ(outer.least_jacobian_bound, hexes.least_jacobian_bound);
}

/// Their normals point out of the body, whose middle is (0.5, 0.5, 0.25).
TEST(OuterFaces, AreCounterClockwiseFromOutside) {
  const QuadMesh outer = outer_faces(samples::hex_mesh());
  for (int e = 0; e < outer.num_elems(); ++e) {
    const auto corner = [&](int k) { return outer.space_nodes[side_start(outer, e, k)]; };
    const Vec3 normal = cross(corner(1) - corner(0), corner(3) - corner(0));
    EXPECT_GT(dot(normal, corner(0) - Vec3{0.5, 0.5, 0.25}), 0) << e;
  }
}

/// Of the box with its twelve edges: the four long ones are divided in two.
TEST(OuterFaces, EdgesBetweenGroupsAreOnTheBoundaryOfBoth) {
  const QuadMesh outer = outer_faces(samples::hex_mesh());
  EXPECT_EQ(outer.boundary_edges.size(), 2u * 16);
  std::set<int> groups;
  for (const QuadBoundaryEdge& edge : outer.boundary_edges) groups.insert(edge.curve);
  EXPECT_EQ(groups, (std::set<int>{0, 1, 2, 3, 4, 5}));
}

/// A ring of two elements of order 2, each of which has a side between the same vertices on either circle.
TEST(Borders, SidesWithTheSameEndsAreTold) {
  QuadMesh ring;
  ring.order = 2;
  ring.elem_block = {0, 1};
  ring.elem_nodes = {0, 1, 2, 3, 4, 5, 6, 7, 8, 6, 7, 8, 9, 10, 11, 0, 1, 2};
  const std::vector<Border> between = borders(ring, {0, 1});
  ASSERT_EQ(between.size(), 2u);
  EXPECT_EQ(side_node(ring, between[0].first.elem, between[0].first.side, 1), 7);
  EXPECT_EQ(side_node(ring, between[1].first.elem, between[1].first.side, 1), 1);
  EXPECT_TRUE(borders(ring, {3, 3}).empty());
}

TEST(OuterFaces, InterfacesAreInside) {
  HexMesh hexes = samples::hex_mesh();
  hexes.face_groups.push_back({"between", {0, 1}, {1, 3}, true});
  EXPECT_EQ(outer_faces(hexes).num_elems(), 10);
}

TEST(OuterFaces, FiguresAreThoseOfTheElement) {
  HexMesh hexes = samples::hex_mesh();
  hexes.elem_scaled_jacobian = {0.25, 0.75};
  hexes.elem_jacobian_bound = {0.1, -0.2};
  hexes.is_valid = false;
  const QuadMesh outer = outer_faces(hexes);
  EXPECT_FALSE(outer.is_valid);
  EXPECT_EQ(std::ranges::count(outer.elem_scaled_jacobian, 0.25), 5);
  EXPECT_EQ(std::ranges::count(outer.elem_jacobian_bound, -0.2), 5);
}

TEST(Borders, LieBetweenElementsOfDifferentGroups) {
  const QuadMesh mesh = samples::quad_mesh();
  EXPECT_TRUE(borders(mesh, {3, 3}).empty());
  const std::vector<Border> found = borders(mesh, {3, 4});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].first.elem, 0);
  EXPECT_EQ(found[0].first.side, 1);
  EXPECT_EQ(found[0].second.elem, 1);
  EXPECT_EQ(found[0].second.side, 3);
}

}  // namespace
}  // namespace quadrille::mesh
