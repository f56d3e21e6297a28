#include "mesh/tri_maps.hpp"

#include <gtest/gtest.h>

#include "base/angle.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::mesh {

namespace {

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
