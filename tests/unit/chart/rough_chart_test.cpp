#include "chart/rough_chart.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../support/texts.hpp"
#include "base/error.hpp"
#include "surface_samples.hpp"

namespace quadrille::chart {
namespace {

/// Triangles with straight edges are shorter than the surface by at most the square of the step, 1/6 radian.
TEST(RoughChart, ACylinderIsUnrolled) {
  const SurfaceSample sample(cylinder_patch());
  const SurfaceMesh& mesh = sample.rough;
  for (int e = 0; e < mesh.num_elems(); ++e)
    for (int k = 0; k < 3; ++k) {
      const double image = distance(mesh.image[3 * e + k], mesh.image[3 * e + (k + 1) % 3]);
      EXPECT_NEAR(image, sample.fine.triangles[e].lengths[k], 2e-3);
    }
}

TEST(RoughChart, TrianglesAreCounterClockwise) {
  for (const SpaceFace& face : {cylinder_patch(), tube(), cap()}) {
    const SurfaceSample sample(face);
    const SurfaceMesh& mesh = sample.rough;
    for (int e = 0; e < mesh.num_elems(); ++e)
      EXPECT_GT(cross(mesh.image[3 * e + 1] - mesh.image[3 * e], mesh.image[3 * e + 2] - mesh.image[3 * e]), 0) << e;
  }
}

TEST(RoughChart, BoundaryEdgesAreSortedByCurveAndParameter) {
  const SurfaceSample sample(tube());
  const std::vector<BoundaryEdge>& edges = sample.rough.plane.boundary_edges;
  EXPECT_EQ(edges.size(), sample.fine.boundary_edges.size());
  EXPECT_TRUE(std::ranges::is_sorted(edges, {}, [](const BoundaryEdge& e) { return std::pair(e.curve, e.t0); }));
  for (std::size_t i = 1; i < edges.size(); ++i)
    if (edges[i].curve == edges[i - 1].curve) {
      EXPECT_EQ(edges[i].t0, edges[i - 1].t1);
    }
}

/// Of a tube of radius 1 and height 1 the ring has the length of the outline, and the ratio e of its radii.
TEST(RoughChart, ATubeIsARing) {
  const SurfaceSample sample(tube());
  Vec2 middle;
  const SurfaceMesh& mesh = sample.rough;
  int count = 0;
  for (const BoundaryEdge& edge : mesh.plane.boundary_edges)
    if (edge.curve == 0) middle += mesh.image[3 * edge.elem + edge.edge], ++count;
  middle = middle / count;
  for (const BoundaryEdge& edge : mesh.plane.boundary_edges)
    EXPECT_NEAR(distance(mesh.image[3 * edge.elem + edge.edge], middle), edge.curve == 0 ? 1 : std::exp(-1), 0.02);
}

/// The tip of a cap has no normal: there it is that of the other corners.
TEST(RoughChart, HasANormalEverywhere) {
  const SurfaceSample sample(cap());
  for (std::size_t i = 0; i < sample.rough.nodes.size(); ++i) {
    EXPECT_NEAR(norm(sample.rough.normals[i]), 1, 1e-12);
    EXPECT_GT(dot(sample.rough.normals[i], sample.rough.nodes[i]), 0.9) << "outwards";
  }
}

TEST(RoughChart, TrianglesThatAreNotConnectedAreRefused) {
  SurfaceSample sample(cylinder_patch());
  IntrinsicTriangles two = sample.fine;
  const int num_vertices = static_cast<int>(two.vertices.size()),
            num_edges = static_cast<int>(two.boundary_edges.size()),
            num_triangles = static_cast<int>(two.triangles.size());
  two.vertices.insert(two.vertices.end(), sample.fine.vertices.begin(), sample.fine.vertices.end());
  two.normals.insert(two.normals.end(), sample.fine.normals.begin(), sample.fine.normals.end());
  for (FineBoundaryEdge edge : sample.fine.boundary_edges) {
    for (int& v : edge.vertices) v += num_vertices;
    two.boundary_edges.push_back(edge);
  }
  for (IntrinsicTriangle triangle : sample.fine.triangles) {
    for (int& v : triangle.vertices) v += num_vertices;
    for (int& across : triangle.across) across += across < 0 ? -num_edges : 3 * num_triangles;
    two.triangles.push_back(triangle);
  }
  EXPECT_EQ(message_of<ComputeError>([&] { rough_chart(sample.face.face, two); }),
            "the fine triangles of the face are no connected surface");
}

}  // namespace
}  // namespace quadrille::chart
