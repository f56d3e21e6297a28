#include <gtest/gtest.h>

#include <cmath>

#include "base/angle.hpp"
#include "sweep_samples.hpp"

namespace quadrille::sweep {
namespace {

TEST(Measure, AStraightSweepCarriesTheProofOfTheQuads) {
  for (const int order : {1, 2, 5}) {
    const HexMesh mesh = swept(quads(order), straight({0, 0, 2}), {0, 0.25, 1});
    ASSERT_EQ(mesh.num_elems(), 4);
    EXPECT_EQ(mesh.num_layers(), 2);
    EXPECT_NEAR(mesh.elem_jacobian_bound[0], 0.1 * 0.25, 1e-9);
    EXPECT_NEAR(mesh.elem_jacobian_bound[3], 0.1 * 0.75, 1e-9);
    EXPECT_EQ(mesh.elem_scaled_jacobian[2], 0.9);
    expect_proved(mesh);
  }
}

TEST(Measure, AnObliqueSweepIsSkewed) {
  const HexMesh mesh = swept(quads(2), straight({1, 0, 1}), {0, 1});
  EXPECT_NEAR(mesh.elem_jacobian_bound[0], 0.1 / 2, 1e-9);
  EXPECT_NEAR(mesh.elem_scaled_jacobian[0], 0.9 * std::sqrt(0.5), 1e-12);
  expect_proved(mesh);
}

TEST(Measure, EqualLayersOfARevolutionAreProvedOnce) {
  const HexMesh mesh = swept(quads(4), revolved(pi / 2, {-1, 0, 0}, {0, 1, 0}), {0, 0.25, 0.5, 0.75, 1});
  expect_proved(mesh);
  for (int e = 2; e < 8; ++e) {
    EXPECT_NEAR(mesh.elem_jacobian_bound[e], mesh.elem_jacobian_bound[e % 2], 1e-9);
    EXPECT_EQ(mesh.elem_scaled_jacobian[e], mesh.elem_scaled_jacobian[e % 2]);
  }
  // The face turns to x = -1.
  const Vec3 last = mesh.nodes.back();
  EXPECT_NEAR(last.x, -1, 1e-14);
  EXPECT_NEAR(last.y, 1, 1e-14);
  EXPECT_NEAR(std::abs(last.z), 2, 1e-14);
}

/// Where bounds carried from the quads leave nothing after the rounding of the nodes, the hexahedra are proved.
TEST(Measure, BoundsThatSayNothingAreReplacedByAProof) {
  QuadMesh mesh = quads(2);
  mesh.elem_jacobian_bound = {1e-16, 0.1};
  const HexMesh hexes = swept(mesh, straight({0, 0, 1}), {0, 1});
  EXPECT_GT(hexes.elem_jacobian_bound[0], 0.01);
  EXPECT_EQ(hexes.elem_scaled_jacobian[1], 0.9) << "carried";
  EXPECT_NE(hexes.elem_scaled_jacobian[0], 0.9) << "of the hexahedron";
}

TEST(Measure, LayersOfOtherHeightsOfARevolutionAreProvedThemselves) {
  const HexMesh mesh = swept(quads(3), revolved(pi / 2, {-1, 0, 0}, {0, 1, 0}), {0, 0.25, 0.5, 1});
  EXPECT_NEAR(mesh.elem_jacobian_bound[2], mesh.elem_jacobian_bound[0], 1e-9);
  EXPECT_GT(mesh.elem_jacobian_bound[4], 1.9 * mesh.elem_jacobian_bound[0]);
  EXPECT_EQ(mesh.least_jacobian_bound,
            *std::min_element(mesh.elem_jacobian_bound.begin(), mesh.elem_jacobian_bound.end()));
}

TEST(Measure, AFoldedHexahedronMakesTheMeshInvalid) {
  QuadMesh mesh = quads(1);
  std::swap(mesh.nodes[0], mesh.nodes[1]);
  mesh.elem_jacobian_bound[0] = -0.1, mesh.elem_scaled_jacobian[0] = -1;
  const HexMesh hexes = swept(mesh, straight({0, 0, 1}), {0, 1});
  EXPECT_FALSE(hexes.is_valid);
  EXPECT_LT(hexes.elem_jacobian_bound[0], 0);
  EXPECT_GT(hexes.elem_jacobian_bound[1], 0);
}

TEST(Measure, TheNumberOfThreadsChangesNothing) {
  SweepShape shape = straight({0, 0, 2});
  shape.twist = 1;
  SweepPlan plan;
  for (int k = 0; k <= 80; ++k) plan.ends.push_back(k / 80.0);
  std::vector<std::string> lost;
  const HexMesh one = sweep(quads(2), SweepMotion(shape), plan, 1, nullptr, lost),
                three = sweep(quads(2), SweepMotion(shape), plan, 3, nullptr, lost);
  EXPECT_EQ(one.elem_jacobian_bound, three.elem_jacobian_bound);
  EXPECT_EQ(one.elem_scaled_jacobian, three.elem_scaled_jacobian);
}

}  // namespace
}  // namespace quadrille::sweep
