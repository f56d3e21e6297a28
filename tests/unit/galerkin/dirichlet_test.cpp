#include "galerkin/dirichlet.hpp"

#include <gtest/gtest.h>

#include "../test_meshes.hpp"
#include "mesh/elimination_tree.hpp"
#include "spectral/modified_basis.hpp"

namespace quadrille::galerkin {
namespace {

// The expansion at fraction s of boundary edge b, walked as its element walks it.
Vec2 trace(const TriMesh& mesh, const mesh::TriTopology& topology, const DofMap& map, const Eigen::MatrixX2d& values,
           const BoundaryEdge& b, double s) {
  const auto& vertices = mesh.elem2vertices[b.elem];
  const int v0 = vertices[b.edge], v1 = vertices[(b.edge + 1) % 3], edge = topology.elem2edges[b.elem][b.edge];
  const int order = map.edge2order[edge];
  const auto value = [&](int dof) {
    return Vec2{values(dof - map.num_unknowns, 0), values(dof - map.num_unknowns, 1)};
  };
  Vec2 sum = (1 - s) * value(map.vertex2dof[v0]) + s * value(map.vertex2dof[v1]);
  std::vector<double> modes(order - 1);
  spectral::edge_mode_values(order, 2 * s - 1, modes.data());
  for (int d = 2; d <= order; ++d) {
    const double sign = v0 > v1 && d % 2 == 1 ? -1 : 1;
    sum += sign * modes[d - 2] * value(map.edge2dof[edge] + d - 2);
  }
  return sum;
}

double worst_error(const TriMesh& mesh, int order, const std::function<Vec2(Vec2)>& f) {
  const mesh::TriTopology topology = mesh::tri_topology(mesh);
  const DofMap map = make_dof_map(mesh, topology, mesh::nested_dissection(mesh, topology).elimination_order,
                                  std::vector<int>(mesh.num_elems(), order));
  DirichletData data(mesh, [&](int curve, double t) { return f(curve::point(mesh.face.curves[curve], t)); });
  const Eigen::MatrixX2d values = data.values(topology, map);
  double worst = 0;
  for (const BoundaryEdge& b : mesh.boundary_edges) {
    const curve::ArcLength arc_length(mesh.face.curves[b.curve]);
    for (const double s : {0.0, 0.1, 0.45, 0.8, 1.0}) {
      const double begin = arc_length.at(b.t0), end = arc_length.at(b.t1);
      const Vec2 x = curve::point(mesh.face.curves[b.curve], arc_length.parameter(begin + s * (end - begin)));
      worst = std::max(worst, distance(trace(mesh, topology, map, values, b, s), f(x)));
    }
  }
  return worst;
}

TEST(Dirichlet, PolynomialDataOnStraightSidesAreExact) {
  const TriMesh mesh = parallelogram_mesh({0, 0}, {1, 0.2}, {-0.1, 1}, 3);
  for (const int order : {4, 5, 9, 16}) {
    EXPECT_LT(worst_error(mesh, order, [](Vec2 x) { return Vec2{std::pow(x.x, 4), x.y * x.x - x.y}; }), 1e-14);
  }
}

TEST(Dirichlet, DataFollowTheArcLengthOfACurve) {
  const TriMesh mesh = disc_mesh(8, 6);
  const auto cross_of_circle = [](Vec2 x) { return cross_value(angle_of(x)); };
  EXPECT_LT(worst_error(mesh, 16, cross_of_circle), 1e-12);
  EXPECT_GT(worst_error(mesh, 4, cross_of_circle), 1e-4);
}

}  // namespace
}  // namespace quadrille::galerkin
