#include "galerkin/phase_gradient.hpp"

#include <gtest/gtest.h>

#include "../test_meshes.hpp"
#include "base/error.hpp"
#include "mesh/tri_maps.hpp"
#include "spectral/orthogonal_basis.hpp"

namespace quadrille::galerkin {
namespace {

// W of two nodes in the whole plane is -2 pi d_1 d_2 ln |a_1 - a_2|: nodes of one sign repel each other.
TEST(PhaseGradient, OfTwoNodesIsAlongTheLineBetweenThem) {
  PhaseTerms terms;
  terms.nodes = {{{1, 0}, 1}, {{-1, 0}, 1}};
  EXPECT_NEAR(distance(phase_energy_gradient(terms, 0, {}), {-pi, 0}), 0, 1e-14);
  EXPECT_NEAR(distance(phase_energy_gradient(terms, 1, {}), {pi, 0}), 0, 1e-14);
  terms.nodes[1].turns = -1;
  EXPECT_NEAR(distance(phase_energy_gradient(terms, 0, {}), {pi, 0}), 0, 1e-14);
}

TEST(PhaseGradient, AddsTheRemainderTurnedByAQuarterTurn) {
  PhaseTerms terms;
  terms.nodes = {{{1, 0}, -2}};
  EXPECT_NEAR(distance(phase_energy_gradient(terms, 0, {3, 4}), 4 * pi * Vec2{4, -3}), 0, 1e-13);
}

TEST(PhaseGradient, OfTheRemainderIsInThePlane) {
  const spectral::TriMap map({Vec2{0.1, -0.2}, Vec2{1.3, 0.1}, Vec2{0.4, 0.9}});
  const std::vector<double> coefs{0.3, -1, 0.7, 0.2, 0.5, -0.4};
  const Vec2 xi{-0.3, -0.5};
  const auto at = [&](Vec2 p) { return spectral::orthogonal_sum(2, coefs.data(), coefs.data(), p).x; };
  const Vec2 slope = remainder_gradient(map, xi, 2, coefs.data());
  const double h = 1e-5;
  for (const Vec2 step : {Vec2{h, 0}, Vec2{0, h}}) {
    const Vec2 dx = map.position(xi + step) - map.position(xi - step);
    EXPECT_NEAR(dot(slope, dx), at(xi + step) - at(xi - step), 1e-9 * h);
  }
}

TEST(PhaseGradient, NodesMustLieInTheMesh) {
  TriMesh mesh = parallelogram_mesh({0, 0}, {2, 0}, {0, 1}, 2);
  mesh.face.origin = {10, 0};
  const std::vector<spectral::TriMap> maps = mesh::tri_maps(mesh);
  const mesh::Locator locator(mesh, maps);
  const mesh::Location at = locate_node(locator, mesh, {0.3, 0.4});
  EXPECT_NEAR(distance(maps[at.elem].position(at.xi), {0.3, 0.4}), 0, 1e-14);
  try {
    locate_node(locator, mesh, {3, 0.5});
    FAIL();
  } catch (const ComputeError& error) {
    EXPECT_EQ(std::string(error.what()), "the irregular node at (13, 0.5) is outside the mesh");
  }
}

}  // namespace
}  // namespace quadrille::galerkin
