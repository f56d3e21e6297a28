#include "midpoint/midpoint_graph.hpp"

#include <gtest/gtest.h>

#include "../triangulate/faces.hpp"
#include "base/error.hpp"
#include "check/check.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille::midpoint {
namespace {

TriMesh triangulated(const CadFace& face) {
  Report report;
  return triangulate::triangulate(face, {}, report);
}

struct Outcome {
  SeparatrixGraph graph;
  long long triangles = 0;
  std::string origin;
};

Outcome divided(const TriMesh& mesh) {
  Report report;
  Outcome outcome{midpoint_graph(mesh, triangulate::coarse_triangles, report), 0, ""};
  for (const auto& [key, value] : report.entries()) {
    if (key == "midpoint.triangles") outcome.triangles = std::get<long long>(value);
    if (key == "midpoint.origin") outcome.origin = std::get<std::string>(value);
  }
  return outcome;
}

TEST(MidpointGraph, KeepsTheRulesOfItsFormat) {
  for (const CadFace& face : {testing_faces::square(), testing_faces::half_disc(), testing_faces::annulus(),
                              testing_faces::l_shape(), testing_faces::stadium()}) {
    const SeparatrixGraph graph = divided(triangulated(face)).graph;
    const std::vector<check::Violation> broken = check::check_stage(graph, check::CheckDepth::full);
    EXPECT_TRUE(broken.empty()) << broken.front().text;
    EXPECT_EQ(index_sum_of(graph), 4 * face.euler_characteristic());
  }
}

TEST(MidpointGraph, TrianglesAreMadeAnewAndFew) {
  const TriMesh mesh = triangulated(testing_faces::l_shape());  // has a fan at the re-entrant corner
  const Outcome outcome = divided(mesh);
  EXPECT_EQ(outcome.origin, "coarse");
  EXPECT_LE(outcome.triangles, 8);
  EXPECT_LT(outcome.triangles, mesh.num_elems() / 2);
}

// A corner whose two sides nearly coincide outside the face needs a ring around it; without one there is no end.
TEST(MidpointGraph, ANarrowNotchHasCoarseTrianglesToo) {
  const CadFace face =
      testing_faces::make_face({testing_faces::polygon({{0, 0}, {4, 0}, {4, 1.9}, {2, 2}, {4, 2.1}, {4, 4}, {0, 4}})});
  const Outcome outcome = divided(triangulated(face));
  EXPECT_EQ(outcome.origin, "coarse");
  EXPECT_LE(outcome.triangles, 100);
}

TEST(MidpointGraph, WithoutCoarseTrianglesThoseOfTheMeshAreDivided) {
  TriMesh mesh = triangulated(testing_faces::square());
  // The mesh is that of a square; the face has a hole as well, which crosses the outline.
  const CadFace crossed = testing_faces::make_face(
      {testing_faces::polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), testing_faces::hole({1, 0.5}, 0.2)});
  mesh.face = crossed;
  const Outcome outcome = divided(mesh);
  EXPECT_EQ(outcome.origin, "field");
  EXPECT_EQ(outcome.triangles, mesh.num_elems());
}

TEST(MidpointGraph, WithoutAMesherThereIsNone) {
  Report report;
  EXPECT_THROW(midpoint_graph(triangulated(testing_faces::square()), {}, report), ComputeError);
}

}  // namespace
}  // namespace quadrille::midpoint
