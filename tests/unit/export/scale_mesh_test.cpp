#include "export/scale_mesh.hpp"

#include <gtest/gtest.h>

#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

TEST(ScaleMesh, LengthsGetTheFactorAndJacobiansItsSquare) {
  QuadMesh mesh = two_quads();
  mesh.face.origin = {10, 20};
  mesh.elem_node_distance = {0.5, 1};
  mesh.least_jacobian_bound = 0.5;
  scale_mesh(mesh, {0.1, "centimetre", 0.01});
  EXPECT_EQ(mesh.nodes[13], (0.1 * Vec2{3, 2.5}));
  EXPECT_EQ(mesh.face.origin, (0.1 * Vec2{10, 20}));
  EXPECT_DOUBLE_EQ(mesh.face.diameter, 0.5);
  EXPECT_DOUBLE_EQ(mesh.elem_jacobian_bound[1], 0.005);
  EXPECT_DOUBLE_EQ(mesh.least_jacobian_bound, 0.005);
  EXPECT_DOUBLE_EQ(mesh.elem_node_distance[0], 0.05);
  EXPECT_EQ(mesh.elem_scaled_jacobian, two_quads().elem_scaled_jacobian);
  EXPECT_EQ(mesh.face.length_unit, "centimetre");
  EXPECT_EQ(mesh.face.metres_per_unit, 0.01);
}

}  // namespace
}  // namespace quadrille::exports
