#include "triangulate/draft.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../regions/faces_of_regions.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "faces.hpp"
#include "mesh/tri_topology.hpp"
#include "triangulate/curved_edges.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille::triangulate {
namespace {

using namespace testing_faces;

/// A square of four triangles around its centre, cut from the centre to the right or across.
Draft four_triangles() {
  Draft draft;
  for (const Vec2 x : {Vec2{-1, 0}, {0, -1}, {1, 0}, {0, 1}, {0, 0}}) draft.add_vertex(x);
  for (int k = 0; k < 4; ++k) {
    draft.add_triangle(k, (k + 1) % 4, 4, -1);
    draft.edges.push_back({k, (k + 1) % 4, k, 0, 1});
  }
  return draft;
}

TEST(CutSlits, LeavesAMeshWithoutSlitsUnchanged) {
  Draft draft = four_triangles();
  EXPECT_EQ(cut_slits(draft), (std::vector<int>{0, 1, 2, 3, 4}));
  EXPECT_EQ(draft.triangles[0], (std::array<int, 3>{0, 1, 4}));
}

TEST(CutSlits, DoublesTheEndOnTheBoundaryAndKeepsTheTip) {
  Draft draft = four_triangles();
  draft.edges.push_back({4, 2, 4, 0, 1});
  draft.edges.push_back({2, 4, 5, 0, 1});
  EXPECT_EQ(cut_slits(draft), (std::vector<int>{0, 1, 2, 3, 4, 2}));
  EXPECT_EQ(draft.triangles[1], (std::array<int, 3>{1, 2, 4}));
  EXPECT_EQ(draft.triangles[2], (std::array<int, 3>{5, 3, 4}));
  EXPECT_EQ(draft.edges[4].to, 5);
  EXPECT_EQ(draft.edges[5].from, 2);
}

TEST(CutSlits, SeparatesTheHalvesOfASquareThatIsCutAcross) {
  Draft draft = four_triangles();
  for (const auto& [a, b] : {std::pair(0, 4), std::pair(4, 2)}) {
    draft.edges.push_back({a, b, 4, 0, 1});
    draft.edges.push_back({b, a, 5, 0, 1});
  }
  EXPECT_EQ(cut_slits(draft), (std::vector<int>{0, 1, 2, 3, 4, 0, 2, 4}));
  EXPECT_EQ(draft.triangles[3], (std::array<int, 3>{3, 5, 7}));
}

TEST(CutSlits, SeparatesTheSectorsOfARegionThatTouchesItself) {
  Draft draft;
  for (const Vec2 x : {Vec2{0, 0}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}}) draft.add_vertex(x);
  for (const auto& [a, b] : {std::pair(1, 2), std::pair(3, 4)}) {
    draft.add_triangle(0, a, b, -1);
    for (const auto& [from, to] : {std::pair(0, a), std::pair(a, b), std::pair(b, 0)})
      draft.edges.push_back({from, to, static_cast<int>(draft.edges.size()), 0, 1});
  }
  EXPECT_EQ(cut_slits(draft), (std::vector<int>{0, 1, 2, 3, 4, 0}));
  EXPECT_EQ(draft.triangles[1], (std::array<int, 3>{5, 3, 4}));
  EXPECT_EQ(draft.edges[3].from, 5);
  EXPECT_EQ(draft.edges[5].to, 5);
}

TEST(Triangulate, ARegionThatTouchesItselfIsADiscWithTwoVerticesThere) {
  const CadFace face = pinched_square();
  Report report;
  const TriMesh mesh = triangulate(face, {}, report);
  const mesh::TriTopology topology = mesh::tri_topology(mesh);
  EXPECT_EQ(static_cast<int>(mesh.vertices.size()) - static_cast<int>(topology.edge2vertices.size()) + mesh.num_elems(),
            1);
  for (const double ratio : jacobian_ratio_bounds(mesh)) EXPECT_GT(ratio, 0);
  EXPECT_EQ(std::count(mesh.vertices.begin(), mesh.vertices.end(), Vec2{0, 0}), 2);
}

class SlitFaces : public testing::TestWithParam<CadFace (*)()> {};

TEST_P(SlitFaces, HaveSoundMeshesThatMeetInEqualVertices) {
  const CadFace face = GetParam()();
  Report report;
  const TriMesh mesh = triangulate(face, {}, report);
  const mesh::TriTopology topology = mesh::tri_topology(mesh);
  EXPECT_EQ(static_cast<int>(mesh.vertices.size()) - static_cast<int>(topology.edge2vertices.size()) + mesh.num_elems(),
            face.euler_characteristic());
  for (const double ratio : jacobian_ratio_bounds(mesh)) EXPECT_GT(ratio, 0);
  for (int c = 0; c < face.num_curves(); ++c) {
    if (face.partners[c] < c) continue;
    std::vector<Vec2> first, second;
    for (const BoundaryEdge& edge : mesh.boundary_edges) {
      const auto& v = mesh.elem2vertices[edge.elem];
      if (edge.curve == c) first.push_back(mesh.vertices[v[edge.edge]]);
      if (edge.curve == face.partners[c]) second.push_back(mesh.vertices[v[(edge.edge + 1) % 3]]);
    }
    std::reverse(second.begin(), second.end());
    ASSERT_EQ(first.size(), second.size());
    EXPECT_GE(first.size(), 1U);
    for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(distance(first[i], second[i]), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(All, SlitFaces, testing::Values(slit_square, arc_slit, open_slit, cut_annulus, slanted_slit));

TEST(Smooth, ShapeIsOneForEquilateralZeroForFlatAndChangesSignWithOrientation) {
  EXPECT_NEAR(triangle_shape({0, 0}, {1, 0}, unit(pi / 3)), 1, 1e-15);
  EXPECT_EQ(triangle_shape({0, 0}, {1, 0}, {2, 0}), 0);
  EXPECT_LT(triangle_shape({0, 0}, {0, 1}, {1, 0}), 0);
}

/// A hexagon with its centre out of place.
Draft hexagon() {
  Draft draft;
  for (int k = 0; k < 6; ++k) draft.add_vertex(unit(k * pi / 3));
  const int centre = draft.add_vertex({0.5, 0.2});
  for (int k = 0; k < 6; ++k) draft.add_triangle(k, (k + 1) % 6, centre, -1);
  return draft;
}

TEST(Smooth, AFreeVertexGoesToTheMiddle) {
  Draft draft = hexagon();
  smooth(draft, {0, 0, 0, 0, 0, 0, 1});
  EXPECT_NEAR(norm(draft.vertices[6]), 0, 1e-12);
}

TEST(Smooth, OtherVerticesStay) {
  Draft draft = hexagon();
  const auto before = draft.vertices;
  smooth(draft, {0, 0, 0, 0, 0, 0, 0});
  EXPECT_EQ(draft.vertices, before);
}

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
