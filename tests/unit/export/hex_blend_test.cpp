#include "export/hex_blend.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "../support/texts.hpp"
#include "base/error.hpp"
#include "two_hexes.hpp"

namespace quadrille::exports {
namespace {

/// One hexahedron [0, 1]^3 of an order, moved by a map; nodes in the order of its coordinates.
HexMesh cube(int order, const std::function<Vec3(Vec3)>& map) {
  HexMesh mesh;
  mesh.order = order, mesh.num_quads = 1, mesh.diameter = 1;
  const auto at = [&](int i) { return (1 + spectral::gll_points(order)[i]) / 2; };
  for (int k = 0; k <= order; ++k)
    for (int j = 0; j <= order; ++j)
      for (int i = 0; i <= order; ++i) mesh.nodes.push_back(map({at(i), at(j), at(k)}));
  mesh.elem_nodes.resize(mesh.nodes.size());
  std::iota(mesh.elem_nodes.begin(), mesh.elem_nodes.end(), 0);
  mesh.elem_jacobian_bound = {1}, mesh.elem_scaled_jacobian = {1};
  return mesh;
}

std::vector<int> first(int count) {
  std::vector<int> nodes(count);
  std::iota(nodes.begin(), nodes.end(), 0);
  return nodes;
}

double bubble(double t) { return 4 * t * (1 - t); }

TEST(BlendDistance, OfAnEdgeIsItsSagFromTheStraightLine) {
  const HexMesh mesh = cube(2, [](Vec3 x) { return Vec3{x.x, x.y + 0.1 * bubble(x.x), x.z}; });
  EXPECT_NEAR(blend_distance(mesh, first(3)), 0.1, 1e-15);
  EXPECT_FALSE(is_blend(mesh, first(3)));
}

/// x y is linear in both; bubbles of one coordinate are those of the sides; a product of two bubbles is neither.
TEST(BlendDistance, OfAFaceIsWhatItsSidesDoNotTell) {
  const auto of = [](const std::function<double(Vec3)>& z) {
    const HexMesh mesh = cube(4, [&](Vec3 x) { return Vec3{x.x, x.y, x.z + z(x)}; });
    return blend_distance(mesh, first(25));
  };
  EXPECT_NEAR(of([](Vec3 x) { return x.x * x.y; }), 0, 1e-15);
  EXPECT_NEAR(of([](Vec3 x) { return 0.2 * bubble(x.x) + 0.1 * x.x * bubble(x.y); }), 0, 1e-15);
  EXPECT_NEAR(of([](Vec3 x) { return 0.1 * bubble(x.x) * bubble(x.y); }), 0.1, 1e-15);
}

TEST(BlendDistance, OfAHexahedronIsWhatItsFacesDoNotTell) {
  const auto of = [](const std::function<double(Vec3)>& z) {
    return face_blend_loss(cube(2, [&](Vec3 x) { return Vec3{x.x, x.y, x.z + z(x)}; }));
  };
  EXPECT_NEAR(of([](Vec3 x) { return 0.1 * bubble(x.x) * bubble(x.y); }), 0, 1e-15);
  EXPECT_NEAR(of([](Vec3 x) { return 0.1 * bubble(x.x) * bubble(x.y) * bubble(x.z); }), 0.1, 1e-15);
}

/// By the shortest line from corner to corner, not by the diameter: of a thin element a bend counts.
TEST(IsBlend, ComparesWithTheShortestLine) {
  const auto thin = [](double sag) {
    return cube(2, [=](Vec3 x) { return Vec3{x.x, 1e-6 * x.y + sag * bubble(x.x) * bubble(x.y), x.z}; });
  };
  EXPECT_TRUE(is_blend(thin(0), first(9)));
  EXPECT_FALSE(is_blend(thin(1e-12), first(9)));
  const HexMesh thick = cube(2, [](Vec3 x) { return Vec3{x.x, x.y + 5e-11 * bubble(x.x) * bubble(x.y), x.z}; });
  EXPECT_TRUE(is_blend(thick, first(9)));
}

TEST(EdgeMiddle, IsTheValueOfThePolynomialAtZero) {
  const HexMesh mesh = cube(3, [](Vec3 x) { return Vec3{x.x, x.x * x.x * x.x, 0}; });
  const Vec3 middle = edge_middle(mesh, {0, 1, 2, 3});
  EXPECT_NEAR(middle.x, 0.5, 1e-15);
  EXPECT_NEAR(middle.y, 0.125, 1e-15);
}

TEST(QuadraticEdgeLoss, IsNoneOfParabolas) {
  const HexMesh mesh = cube(4, [](Vec3 x) {
    return Vec3{x.x, x.y + 0.1 * bubble(x.x), x.z + 0.1 * x.y * bubble(x.x)};
  });
  const QuadraticEdgeLoss loss = quadratic_edge_loss(mesh, "Nek5000");
  EXPECT_NEAR(loss.edges, 0, 1e-14);
  EXPECT_NEAR(loss.others, 0, 1e-14);
}

/// Of x^3 - x, whose parabola through the ends and the middle is 3/4 (x^2 - x); on edges and everywhere else alike.
TEST(QuadraticEdgeLoss, OfACubicEdgeIsItsThirdOrder) {
  const HexMesh mesh = cube(3, [](Vec3 x) { return Vec3{x.x, x.y + 0.1 * (x.x * x.x * x.x - x.x), x.z}; });
  double expected = 0;
  for (const double xi : spectral::gll_points(3)) {
    const double x = (1 + xi) / 2;
    expected = std::max(expected, 0.1 * std::abs(x * x * x - x - 1.5 * (x * x - x)));
  }
  const QuadraticEdgeLoss loss = quadratic_edge_loss(mesh, "Nek5000");
  EXPECT_NEAR(loss.edges, expected, 1e-15);
  EXPECT_NEAR(loss.others, expected, 1e-15);
}

/// A face that bends through the middle while its edges are straight.
TEST(QuadraticEdgeLoss, InsideFacesIsCountedApart) {
  const HexMesh mesh = cube(2, [](Vec3 x) { return Vec3{x.x, x.y, x.z + 0.1 * bubble(x.x) * bubble(x.y)}; });
  const QuadraticEdgeLoss loss = quadratic_edge_loss(mesh, "Nek5000");
  EXPECT_NEAR(loss.edges, 0, 1e-15);
  EXPECT_NEAR(loss.others, 0.1, 1e-15);
}

TEST(QuadraticEdgeLoss, AFoldedElementIsRefusedWithThePlaceAndTheReader) {
  const HexMesh mesh = cube(4, [](Vec3 x) { return Vec3{x.x + 3 * bubble(x.x), x.y, x.z} + Vec3{5, 0, 0}; });
  EXPECT_EQ(message_of<ComputeError>([&] { quadratic_edge_loss(mesh, "Nek5000"); }),
            "the hexahedron at (5, 0, 0) is folded if it is rebuilt from quadratic edges, as Nek5000 does: refine the "
            "mesh");
}

}  // namespace
}  // namespace quadrille::exports
