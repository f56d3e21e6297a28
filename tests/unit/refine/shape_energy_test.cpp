#include "refine/shape_energy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "../hand_made.hpp"
#include "../support/refined.hpp"
#include "refine/node_follow.hpp"

namespace quadrille::refine {
namespace {

TEST(ShapeEnergy, OfARectangleIsOneWhateverItsProportions) {
  QuadMesh mesh = refined(hand_made::unit_square(), {1, 3, 1e-6});
  for (Vec2& x : mesh.nodes) x.x *= 50;
  EXPECT_NEAR(ShapeEnergy(mesh).value(0, mesh.nodes), 1, 1e-12);
}

TEST(ShapeEnergy, OfAParallelogramIsAPowerOfItsSine) {
  const QuadMesh mesh = refined(hand_made::unit_square(), {1, 2, 1e-6});
  const ShapeEnergy energy(mesh);
  std::vector<Vec2> nodes = mesh.nodes;
  for (Vec2& x : nodes) x = x.x * Vec2{1, 0} + x.y * unit(pi / 6);
  EXPECT_NEAR(energy.value(0, nodes), 16, 1e-12);  // (1 / sin 30 degrees)^4
  for (Vec2& x : nodes) x.y = -x.y;
  EXPECT_EQ(energy.value(0, nodes), std::numeric_limits<double>::infinity());
}

TEST(ShapeEnergy, GradientIsThatOfDifferences) {
  for (const int order : {1, 3}) {
    const QuadMesh mesh = refined(hand_made::unit_square(), {0.25, order, 1e-3});
    const ShapeEnergy energy(mesh);
    std::vector<Vec2> nodes = mesh.nodes;
    for (Vec2& x : nodes) x += 0.05 * Vec2{std::sin(3 * x.y), std::cos(5 * x.x)};
    const BoundarySlide boundary(mesh);
    const NodeFollow follow(mesh, boundary);
    const int elem = 5;  // inside
    const ElementEnergy e = energy.with_derivatives(elem, nodes);
    EXPECT_NEAR(e.value, energy.value(elem, nodes), 1e-13);
    for (int c = 0; c < 4; ++c)
      for (const Vec2 d : {Vec2{1, 0}, Vec2{0, 1}}) {
        const double h = 1e-6;
        const auto shifted = [&](double by) {  // bilinearly, as inner nodes follow
          std::vector<Vec2> all = nodes;
          VertexMoves moves(follow.num_vertices());
          const int vertex = follow.elem_vertices()[elem][c];
          moves[vertex] = by * d;
          const std::vector<Vec2> moved = follow.nodes(moves);
          for (std::size_t i = 0; i < all.size(); ++i) all[i] += moved[i] - mesh.nodes[i];
          return energy.value(elem, all);
        };
        const double slope = (shifted(h) - shifted(-h)) / (2 * h);
        EXPECT_NEAR(dot(e.gradient[c], d), slope, 1e-6 * (1 + std::abs(slope))) << order;
        EXPECT_GT(e.hessian[c][0] * e.hessian[c][2], e.hessian[c][1] * e.hessian[c][1]);
      }
  }
}

}  // namespace
}  // namespace quadrille::refine
