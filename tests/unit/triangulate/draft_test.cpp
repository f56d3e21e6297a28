#include "triangulate/draft.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "faces.hpp"
#include "mesh/tri_topology.hpp"
#include "triangulate/curve_elements.hpp"
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

INSTANTIATE_TEST_SUITE_P(All, SlitFaces, testing::Values(slit_square, arc_slit, open_slit, cut_annulus));

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

}  // namespace
}  // namespace quadrille::triangulate
