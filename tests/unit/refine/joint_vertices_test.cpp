#include "refine/joint_vertices.hpp"

#include <gtest/gtest.h>

#include "../hand_made.hpp"
#include "../support/refined.hpp"

namespace quadrille::refine {
namespace {

TEST(JointVertices, CurvesThatBeginInsideAnEdgeAreFoundAndReported) {
  // Coarse and lax: edges pass smooth joints of the bend.
  QuadMesh mesh = refined(hand_made::elbow(), {.size = 1.3, .order = 4, .geometry_tol = 0.1, .relax = Relax::none});
  const std::vector<int> joints = joints_inside_edges(mesh);
  ASSERT_FALSE(joints.empty());
  for (const int joint : joints) EXPECT_TRUE(joint == 1 || joint == 4) << joint;
  Report report;
  warn_of_joints(mesh, report);
  ASSERT_EQ(report.warnings().size(), 1u);
  EXPECT_EQ(report.warnings()[0].code, "W-QUA-006");
  mesh.face.curve_names.assign(mesh.face.curve_names.size(), "wall");
  EXPECT_TRUE(joints_inside_edges(mesh).empty()) << "one name on both sides";
}

TEST(JointVertices, NoWarningWhereAllCurvesBeginAtVertices) {
  const QuadMesh mesh = refined(hand_made::elbow(), {.size = 0.3, .order = 3, .geometry_tol = 1e-3});
  Report report;
  warn_of_joints(mesh, report);
  EXPECT_TRUE(report.warnings().empty());
}

}  // namespace
}  // namespace quadrille::refine
