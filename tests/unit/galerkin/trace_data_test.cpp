#include "galerkin/trace_data.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "../test_meshes.hpp"
#include "curve/nurbs.hpp"
#include "galerkin/trace_element.hpp"

namespace quadrille::galerkin {
namespace {

TEST(TraceData, OfTheCurvesThemselvesRunAlongEachEdgeFromItsLowerVertex) {
  const TriMesh mesh = parallelogram_mesh({0, 0}, {2, 0}, {0.5, 1.5}, 2);
  const mesh::TriTopology topology = mesh::tri_topology(mesh);
  std::vector<int> elimination_order(mesh.vertices.size() + topology.edge2vertices.size());
  std::iota(elimination_order.begin(), elimination_order.end(), 0);
  const DofMap map = make_trace_map(mesh, topology, elimination_order, std::vector<int>(mesh.num_elems(), 3));
  const Eigen::MatrixXd values =
      trace_data(mesh, topology, map, [&](int curve, double t) { return curve::point(mesh.face.curves[curve], t); });
  ASSERT_EQ(values.rows(), map.num_dofs - map.num_unknowns);
  for (const BoundaryEdge& boundary : mesh.boundary_edges) {
    const int edge = topology.elem2edges[boundary.elem][boundary.edge];
    const Vec2 low = mesh.vertices[topology.edge2vertices[edge][0]],
               high = mesh.vertices[topology.edge2vertices[edge][1]];
    for (const double r : {-1.0, -0.3, 0.8}) {
      Eigen::VectorXd modes(4);
      trace_values(3, r, modes.data());
      const Eigen::VectorXd x = values.middleRows(map.edge2dof[edge] - map.num_unknowns, 4).transpose() * modes;
      EXPECT_NEAR(distance({x[0], x[1]}, low + (1 + r) / 2 * (high - low)), 0, 1e-13);
    }
  }
}

}  // namespace
}  // namespace quadrille::galerkin
