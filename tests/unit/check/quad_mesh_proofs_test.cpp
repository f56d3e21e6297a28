#include <gtest/gtest.h>

#include "../chart_samples.hpp"
#include "../region_layout_samples.hpp"
#include "rules_of.hpp"

namespace quadrille::check {
namespace {

TEST(QuadMeshProofs, QuaR09JacobiansArePositive) {
  EXPECT_EQ(broken_rules(samples::quad_mesh(), [](auto& m) { m.nodes[4] = {-0.1, 0.4}; }), Rules{"QUA-R09"});
}

/// By the bound that is stored, not by one that is above 0 elsewhere.
TEST(QuadMeshProofs, ElementsWhoseStoredBoundSaysNothingAreNotProved) {
  const auto turned_over = [](QuadMesh& m) {
    std::swap(m.nodes[0], m.nodes[3]), std::swap(m.nodes[1], m.nodes[4]);
    m.elem_jacobian_bound[0] = m.least_jacobian_bound = -0.1, m.elem_scaled_jacobian[0] = -1;
    m.is_valid = false;
  };
  EXPECT_EQ(broken_rules(samples::quad_mesh(), turned_over), Rules{"QUA-R09"}) << "of the other one";
}

/// The message names the element, its bound and where it begins.
TEST(QuadMeshProofs, AnElementThatIsNotProvedIsNamed) {
  QuadMesh mesh = samples::quad_mesh();
  mesh.nodes[4] = {-0.1, 0.4};
  const std::vector<Violation> violations = check_stage(mesh, CheckDepth::full);
  ASSERT_FALSE(violations.empty());
  EXPECT_TRUE(violations[0].text.starts_with("element 0 is not proved valid: its Jacobian's lower bound is -"))
      << violations[0].text;
  EXPECT_TRUE(violations[0].text.ends_with(", at (0, 0)")) << violations[0].text;
  EXPECT_TRUE(check_stage(mesh, CheckDepth::quick).empty()) << "no proof";
}

/// The sample on the sphere: half as large in the chart.
QuadMesh curved_sample() {
  QuadMesh mesh = samples::quad_mesh();
  mesh.face = samples::sphere_face(1, 2);
  for (Vec2& x : mesh.nodes) x = x / 2;
  for (const Vec2 x : mesh.nodes) mesh.space_nodes.push_back(samples::on_sphere(x));
  return mesh;
}

TEST(QuadMeshProofs, NodesInSpaceAreChecked) {
  const QuadMesh mesh = curved_sample();
  EXPECT_EQ(broken_rules(mesh, [](QuadMesh&) {}), Rules{});
  EXPECT_EQ(broken_rules(mesh, [](QuadMesh& m) { m.space_nodes.pop_back(); }), Rules{"QUA-R01"});
  EXPECT_EQ(broken_rules(mesh, [](QuadMesh& m) { m.face.chart.reset(); }), Rules{"QUA-R01"});
  EXPECT_TRUE(
      broken_rules(mesh, [](QuadMesh& m) { std::swap(m.space_nodes[0], m.space_nodes[1]); }).contains("QUA-R09"))
      << "folded";
}

TEST(QuadMeshProofs, QuaR15BoundaryNodesAreOnTheirCurvesInSpace) {
  EXPECT_EQ(broken_rules(curved_sample(), [](QuadMesh& m) { m.space_nodes[4].z += 1e-8; }), Rules{"QUA-R15"});
  EXPECT_EQ(broken_rules(curved_sample(),
                         [](QuadMesh& m) {
                           m.space_nodes[1] = samples::on_sphere({0.26, 0});
                         }),
            Rules{"QUA-R15"});
}

}  // namespace
}  // namespace quadrille::check
