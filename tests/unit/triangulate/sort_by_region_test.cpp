#include "triangulate/sort_by_region.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../regions/faces_of_regions.hpp"
#include "mesh/tri_topology.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille::triangulate {
namespace {

using namespace testing_faces;

/// Two triangles on either side of a diagonal, the first one of region 1.
TriMesh two_triangles() {
  TriMesh mesh;
  mesh.face =
      face_of_regions({make_face({polygon({{0, 0}, {1, 0}, {1, 1}})}), make_face({polygon({{0, 0}, {1, 1}, {0, 1}})})});
  mesh.vertices = {{0, 0}, {1, 1}, {0, 1}, {0, 0}, {1, 0}, {1, 1}};
  mesh.elem2vertices = {{0, 1, 2}, {3, 4, 5}};
  mesh.elem_layer = {-1, 0};
  for (int k = 0; k < 3; ++k) mesh.boundary_edges.push_back({1, k, k, 0, 1});
  for (int k = 0; k < 3; ++k) mesh.boundary_edges.push_back({0, k, 3 + k, 0, 1});
  return mesh;
}

TEST(SortByRegion, PutsElementsAndVerticesInTheOrderOfRegions) {
  TriMesh mesh = two_triangles();
  EXPECT_EQ(sort_by_region(mesh), (std::vector<int>{3, 4, 5, 0, 1, 2}));
  EXPECT_EQ(mesh.region_elems, (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(mesh.elem2vertices, (std::vector<std::array<int, 3>>{{0, 1, 2}, {3, 4, 5}}));
  EXPECT_EQ(mesh.elem_layer, (std::vector<int>{0, -1}));
  EXPECT_EQ(mesh.vertices[1].x, 1);
  for (const BoundaryEdge& edge : mesh.boundary_edges) EXPECT_EQ(edge.elem, edge.curve / 3);
}

TEST(SortByRegion, OneRegionKeepsItsOrder) {
  TriMesh mesh = two_triangles();
  mesh.face = square();
  mesh.boundary_edges.clear();
  const auto before = mesh.elem2vertices;
  EXPECT_EQ(sort_by_region(mesh), (std::vector<int>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(mesh.elem2vertices, before);
  EXPECT_TRUE(mesh.region_elems.empty());
}

TEST(Triangulate, RegionsHaveTheSameEdgesOnTheirInterface) {
  Report report;
  const CadFace face = disc_in_square();
  const TriMesh mesh = triangulate(face, {}, report);
  mesh::tri_topology(mesh);
  ASSERT_EQ(mesh.region_elems.size(), 3U);
  EXPECT_GT(mesh.region_elems[1], 0);
  EXPECT_EQ(mesh.region_elems[2], mesh.num_elems());
  std::vector<double> positions[2];
  for (const BoundaryEdge& edge : mesh.boundary_edges) {
    const int region = edge.elem < mesh.region_elems[1] ? 0 : 1;
    EXPECT_EQ(face.region_of_loop(face.loop_of(edge.curve)), region);
    if (face.is_interface(edge.curve))
      for (const int end : {edge.edge, (edge.edge + 1) % 3})
        positions[region].push_back(angle_of(mesh.vertices[mesh.elem2vertices[edge.elem][end]]));
  }
  for (auto& angles : positions) std::sort(angles.begin(), angles.end());
  EXPECT_EQ(positions[0], positions[1]);
}

}  // namespace
}  // namespace quadrille::triangulate
