#include "mesh/tri_topology.hpp"

#include <gtest/gtest.h>

#include "../triangulate/faces.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/report.hpp"
#include "check/check.hpp"
#include "spectral/tri_map.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille::mesh {

namespace {

// 3---2
// | / |   element 0 = (0, 1, 2), element 1 = (0, 2, 3)
// 0---1
TriMesh two_triangles() {
  TriMesh mesh;
  mesh.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.elem2vertices = {{0, 1, 2}, {0, 2, 3}};
  mesh.boundary_edges = {{0, 0, 0, 0, 1}, {0, 1, 1, 0, 1}, {1, 1, 2, 0, 1}, {1, 2, 3, 0, 1}};
  return mesh;
}

TEST(TriTopology, TwoTrianglesShareTheirDiagonal) {
  const TriTopology topology = tri_topology(two_triangles());
  const std::vector<std::array<int, 2>> edges{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {2, 3}};
  EXPECT_EQ(topology.edge2vertices, edges);
  EXPECT_EQ(topology.edge2elems[1], (std::array<int, 2>{0, 1}));
  EXPECT_EQ(topology.edge2elems[0], (std::array<int, 2>{0, -1}));
  EXPECT_EQ(topology.elem2edges[0], (std::array<int, 3>{0, 3, 1}));
  EXPECT_EQ(topology.elem2edges[1], (std::array<int, 3>{1, 4, 2}));
  EXPECT_EQ(topology.elem2neighbors[0], (std::array<int, 3>{-1, -1, 1}));
  EXPECT_EQ(topology.elem2neighbors[1], (std::array<int, 3>{0, -1, -1}));
  EXPECT_EQ(topology.elem2neighbor_edges[0], (std::array<int, 3>{-1, -1, 0}));
  EXPECT_EQ(topology.elem2neighbor_edges[1], (std::array<int, 3>{2, -1, -1}));
  EXPECT_EQ(topology.elem2boundary_edge[0], (std::array<int, 3>{0, 1, -1}));
  EXPECT_EQ(topology.elem2boundary_edge[1], (std::array<int, 3>{-1, 2, 3}));
}

TEST(TriTopology, RefusesAnEdgeOfThreeElements) {
  TriMesh mesh = two_triangles();
  mesh.vertices.push_back({2, 2});
  mesh.elem2vertices.push_back({2, 0, 4});
  EXPECT_THROW(tri_topology(mesh), FormatError);
}

TEST(TriTopology, RefusesNeighboursOfOppositeOrientation) {
  TriMesh mesh = two_triangles();
  mesh.elem2vertices[1] = {2, 0, 3};
  EXPECT_THROW(tri_topology(mesh), FormatError);
}

TEST(TriTopology, RefusesAnElementThatUsesAVertexTwice) {
  TriMesh mesh = two_triangles();
  mesh.elem2vertices[1] = {0, 2, 2};
  EXPECT_THROW(tri_topology(mesh), FormatError);
}

TEST(TriTopology, RefusesAMissingBoundaryEdge) {
  TriMesh mesh = two_triangles();
  mesh.boundary_edges.pop_back();
  EXPECT_THROW(tri_topology(mesh), FormatError);
}

TEST(TriTopology, RefusesABoundaryEdgeNamedTwice) {
  TriMesh mesh = two_triangles();
  mesh.boundary_edges.push_back(mesh.boundary_edges.front());
  EXPECT_THROW(tri_topology(mesh), FormatError);
}

TEST(TriTopology, RefusesAnInnerEdgeAsBoundary) {
  TriMesh mesh = two_triangles();
  mesh.boundary_edges.push_back({0, 2, 0, 0, 1});
  EXPECT_THROW(tri_topology(mesh), FormatError);
}

TEST(TriTopology, RefusesABoundaryEdgeOfNoElement) {
  TriMesh mesh = two_triangles();
  mesh.boundary_edges.push_back({7, 0, 0, 0, 1});
  EXPECT_THROW(tri_topology(mesh), FormatError);
}

TEST(TriMaps, ElementsOutsideCurvedElemsAreAffineAndTheOthersPassThroughTheirNodes) {
  TriMesh mesh;
  mesh.order = 3;
  mesh.vertices = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  mesh.elem2vertices = {{0, 1, 2}, {0, 2, 3}};
  mesh.curved_elems = {1};
  const auto bent = [](Vec2 xi) { return Vec2{xi.x + 0.1 * xi.y * xi.y, xi.y + 0.05 * xi.x * xi.y * xi.y}; };
  for (const Vec2 xi : spectral::tri_nodes(3)) mesh.curved_nodes.push_back(bent(xi));

  const auto maps = tri_maps(mesh);
  ASSERT_EQ(maps.size(), 2u);
  EXPECT_TRUE(maps[0].is_affine());
  EXPECT_NEAR(distance(maps[0].position({0, 0}), {2, 1}), 0, 1e-15);
  EXPECT_FALSE(maps[1].is_affine());
  const Vec2 xi{-0.3, -0.2};
  EXPECT_NEAR(distance(maps[1].position(xi), bent(xi)), 0, 1e-14);
}

TEST(Quality, OfTheTriangleThreeFourFive) {
  TriMesh mesh;
  mesh.vertices = {{0, 0}, {4, 0}, {0, 3}, {0.5, -0.5 * std::sqrt(3.0)}, {1, 0}};
  mesh.elem2vertices = {{0, 3, 4}, {0, 1, 2}};  // the first is equilateral
  EXPECT_NEAR(least_angle(mesh), std::atan2(3.0, 4.0), 1e-15);
}

TEST(Quality, AnElementTurnedOverHasANegativeAngle) {
  TriMesh mesh;
  mesh.vertices = {{0, 0}, {1, 0}, {0, 1}};
  mesh.elem2vertices = {{0, 2, 1}};
  EXPECT_LT(least_angle(mesh), 0);
}

using namespace testing_faces;

TEST(MirroredMesh, SatisfiesAllRulesOfItsFormat) {
  Loop loop{curve::segment({-3, 0}, {-1, 0}), curve::circular_arc({0, 0}, 1, pi, 0), curve::segment({1, 0}, {3, 0}),
            curve::circular_arc({0, 0}, 3, 0, pi)};
  const CadFace face = make_face({loop, hole({0, 2}, 0.3)});
  Report report;
  const TriMesh half = triangulate::triangulate(face, {}, report);
  const curve::SymmetryLine line = curve::symmetry_lines(face, {0, 2}).lines[0];
  const TriMesh whole = mirrored_mesh(half, curve::mirrored_face(face, line), line);
  EXPECT_EQ(whole.num_elems(), 2 * half.num_elems());
  EXPECT_EQ(whole.face.num_loops(), 4);
  for (const check::Violation& violation : check::check_stage(whole, check::CheckDepth::full))
    ADD_FAILURE() << violation.rule << " " << violation.text;
}

}  // namespace

}  // namespace quadrille::mesh
