#include "mesh/quality.hpp"

#include <gtest/gtest.h>

#include "base/angle.hpp"

namespace quadrille::mesh {
namespace {

TEST(Quality, OfTheTriangleThreeFourFive) {
  TriMesh mesh;
  mesh.vertices = {{0, 0}, {4, 0}, {0, 3}, {0.5, -0.5 * std::sqrt(3.0)}, {1, 0}};
  mesh.elem2vertices = {{0, 3, 4}, {0, 1, 2}};  // the first is equilateral
  EXPECT_NEAR(least_angle(mesh), std::atan2(3.0, 4.0), 1e-15);
  EXPECT_NEAR(least_edge_ratio(mesh), 0.6, 1e-15);
}

TEST(Quality, AnElementTurnedOverHasANegativeAngle) {
  TriMesh mesh;
  mesh.vertices = {{0, 0}, {1, 0}, {0, 1}};
  mesh.elem2vertices = {{0, 2, 1}};
  EXPECT_LT(least_angle(mesh), 0);
}

}  // namespace
}  // namespace quadrille::mesh
