#include "mesh/boundary_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../hand_made.hpp"
#include "base/warning_codes.hpp"

namespace quadrille::mesh {
namespace {

/// One quad of order N on the unit square, whose right side is the graph x = right(y) of the face.
QuadMesh one_quad(int order, std::vector<Nurbs> right) {
  QuadMesh mesh;
  mesh.order = order;
  std::vector<Nurbs> loop{curve::segment({0, 0}, {1, 0})};
  loop.insert(loop.end(), right.begin(), right.end());
  loop.push_back(curve::segment({1, 1}, {0, 1}));
  loop.push_back(curve::segment({0, 1}, {0, 0}));
  mesh.face = hand_made::face({loop}, std::sqrt(2));
  for (int j = 0; j <= order; ++j)
    for (int i = 0; i <= order; ++i) mesh.nodes.push_back({1.0 * i / order, 1.0 * j / order});
  for (int k = 0; k < (order + 1) * (order + 1); ++k) mesh.elem_nodes.push_back(k);
  mesh.elem_block = {0};
  const int last = static_cast<int>(loop.size()) - 1;
  mesh.boundary_edges = {{0, 0, 0}, {0, 1, 1}, {0, 2, last - 1}, {0, 3, last}};
  return mesh;
}

TEST(BoundaryDistance, OfTheSameSquareIsZero) {
  const BoundaryDistance d = boundary_distance(one_quad(2, {curve::segment({1, 0}, {1, 1})}));
  EXPECT_LT(d.worst().distance, 1e-15);
}

TEST(BoundaryDistance, SeesANotchThatThePointsOfTheMeshPassBy) {
  // A notch of the face, 0.02 wide and 0.1 deep: no point of the mesh is farther from the curves than 0.01, but its
  // bottom is 0.1 from the mesh.
  const BoundaryDistance d =
      boundary_distance(one_quad(1, {curve::segment({1, 0}, {1, 0.49}), curve::segment({1, 0.49}, {0.9, 0.5}),
                                     curve::segment({0.9, 0.5}, {1, 0.51}), curve::segment({1, 0.51}, {1, 1})}));
  EXPECT_LT(d.mesh_to_cad.distance, 0.01);
  EXPECT_NEAR(d.cad_to_mesh.distance, 0.1, 1e-12);
  EXPECT_NEAR(d.worst().position.x, 0.9, 1e-12);
}

TEST(BoundaryDistance, SeesABulgeOfTheMesh) {
  QuadMesh mesh = one_quad(2, {curve::segment({1, 0}, {1, 1})});
  mesh.nodes[5].x = 1.125;
  const BoundaryDistance d = boundary_distance(mesh);
  EXPECT_NEAR(d.mesh_to_cad.distance, 0.125, 1e-3);
  EXPECT_LE(d.cad_to_mesh.distance, 0.125 + 1e-12);
  EXPECT_GT(d.cad_to_mesh.distance, 0.1);
}

TEST(BoundaryDistance, CountsWhatSplinesWereMoved) {
  QuadMesh mesh = one_quad(2, {curve::segment({1, 0}, {1, 1})});
  mesh.face.fit_distance = 0.01;
  const BoundaryDistance d = boundary_distance(mesh);
  EXPECT_NEAR(d.mesh_to_cad.distance, 0.01, 1e-15);
  EXPECT_NEAR(d.cad_to_mesh.distance, 0.01, 1e-15);
  Report report;
  report_distance(d, mesh.face, 0.005, report);
  ASSERT_EQ(report.warnings().size(), 1u);
  EXPECT_NE(report.warnings()[0].message.find("lower --fit-tolerance"), std::string::npos);
}

TEST(BoundaryDistance, AboveTheToleranceIsAWarningWithThePlace) {
  QuadMesh mesh = one_quad(2, {curve::segment({1, 0}, {1, 1})});
  mesh.nodes[5].x = 1.125;
  mesh.face.origin = {10, 0};
  Report within, above;
  report_distance(boundary_distance(mesh), mesh.face, 0.2, within);
  report_distance(boundary_distance(mesh), mesh.face, 0.1, above);
  EXPECT_TRUE(within.warnings().empty());
  ASSERT_EQ(above.warnings().size(), 1u);
  EXPECT_EQ(above.warnings()[0].code, warning::geometry_tol_missed);
  EXPECT_NE(above.warnings()[0].message.find("(11"), std::string::npos) << above.warnings()[0].message;
}

}  // namespace
}  // namespace quadrille::mesh
