#include "export/bezier_points.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "../hand_made.hpp"
#include "../support/refined.hpp"
#include "spectral/quad_map.hpp"

namespace quadrille::exports {
namespace {

/// de Casteljau on points[0 .. order * stride].
Vec2 on_curve(const Vec2* points, int order, int stride, double t) {
  std::vector<Vec2> p;
  for (int k = 0; k <= order; ++k) p.push_back(points[k * stride]);
  for (int degree = order; degree > 0; --degree)
    for (int k = 0; k < degree; ++k) p[k] = (1 - t) * p[k] + t * p[k + 1];
  return p[0];
}

TEST(Bezier, ControlPointsGiveTheSameMap) {
  for (const int order : {1, 2, 3, 5, 8, 10}) {
    const QuadMesh mesh = refined(hand_made::s_bend(), {1, order, 5e-7});
    const std::vector<Vec2> control = bezier_points(mesh);
    ASSERT_EQ(control.size(), mesh.nodes.size());
    const int count = mesh.nodes_per_elem();
    for (int elem = 0; elem < mesh.num_elems(); elem += 5) {
      std::vector<Vec2> nodes, points;
      for (int k = 0; k < count; ++k) {
        nodes.push_back(mesh.nodes[mesh.elem_nodes[elem * count + k]]);
        points.push_back(control[mesh.elem_nodes[elem * count + k]]);
      }
      for (const Vec2 xi : {Vec2{-1, -1}, Vec2{0.3, -0.8}, Vec2{-0.1, 0.55}, Vec2{1, 0.2}}) {
        std::vector<Vec2> column;
        for (int j = 0; j <= order; ++j) column.push_back(on_curve(&points[j * (order + 1)], order, 1, (1 + xi.x) / 2));
        const Vec2 x = on_curve(column.data(), order, 1, (1 + xi.y) / 2);
        EXPECT_NEAR(distance(x, spectral::quad_position(order, nodes.data(), xi)), 0, 1e-13) << order;
      }
    }
  }
}

TEST(Bezier, QuadraticArcHasItsPoleWhereTheTangentsMeet) {
  // A parabola through the arc's nodes at -1, 0, 1 has the middle pole 2 x(0) - (x(-1) + x(1)) / 2.
  const QuadMesh mesh = refined(hand_made::quarter_annulus(), {1, 2, 5e-7});
  const std::vector<Vec2> control = bezier_points(mesh);
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const int* ids = &mesh.elem_nodes[elem * 9];
    const Vec2 pole = 2 * mesh.nodes[ids[1]] - (mesh.nodes[ids[0]] + mesh.nodes[ids[2]]) / 2;
    EXPECT_NEAR(distance(control[ids[1]], pole), 0, 1e-15);
    EXPECT_EQ(control[ids[0]], mesh.nodes[ids[0]]);
    EXPECT_EQ(control[ids[8]], mesh.nodes[ids[8]]);
  }
}

}  // namespace
}  // namespace quadrille::exports
