#pragma once
// A square of two quads, and its sweeps.

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "../samples.hpp"
#include "spectral/hex_map.hpp"
#include "spectral/quadrature.hpp"
#include "sweep/sweep.hpp"

namespace quadrille::sweep {

/// The unit square as two quads of the order, whose common side is bent.
inline QuadMesh quads(int order) {
  QuadMesh mesh = samples::quad_mesh();
  mesh.order = order;
  mesh.nodes.clear(), mesh.elem_nodes.clear();
  const std::vector<double>& xi = spectral::gll_points(order);
  const int n = order + 1, row = 2 * order + 1;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < row; ++i) {
      const double y = (1 + xi[j]) / 2, s = i <= order ? (1 + xi[i]) / 4 : (3 + xi[i - order]) / 4;
      mesh.nodes.push_back({s + (order > 1 ? 0.3 * s * (1 - s) * y * (1 - y) : 0), y});
    }
  for (int e = 0; e < 2; ++e)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) mesh.elem_nodes.push_back(j * row + e * order + i);
  mesh.elem_jacobian_bound = {0.1, 0.1};
  mesh.elem_scaled_jacobian = {0.9, 0.9};
  return mesh;
}

inline HexMesh swept(const QuadMesh& mesh, const SweepShape& shape, std::vector<double> ends, SweepPlan plan = {}) {
  plan.ends = std::move(ends);
  std::vector<std::string> lost;
  return sweep(mesh, SweepMotion(shape), plan, 1, nullptr, lost);
}

inline SweepShape straight(Vec3 along) {
  SweepShape shape;
  shape.along = along, shape.normal = {0, 0, 1}, shape.centre = {0.5, 0.5, 0};
  return shape;
}

inline SweepShape revolved(double angle, Vec3 point, Vec3 direction) {
  SweepShape shape = straight({});
  shape.axis = Axis{point, direction}, shape.angle = angle;
  return shape;
}

inline void expect_proved(const HexMesh& mesh) {
  EXPECT_TRUE(mesh.is_valid);
  for (int e = 0; e < mesh.num_elems(); ++e) {
    std::vector<Vec3> nodes;
    for (int k = 0; k < mesh.nodes_per_elem(); ++k)
      nodes.push_back(mesh.nodes[mesh.elem_nodes[e * mesh.nodes_per_elem() + k]]);
    EXPECT_GT(spectral::hex_bounds(mesh.order, nodes.data()).jacobian, 0) << e;
    EXPECT_GT(mesh.elem_jacobian_bound[e], 0) << e;
  }
}

}  // namespace quadrille::sweep
