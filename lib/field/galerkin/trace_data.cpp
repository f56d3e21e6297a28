#include "galerkin/trace_data.hpp"

#include <memory>
#include <vector>

#include "curve/arc_length.hpp"
#include "galerkin/trace_element.hpp"
#include "spectral/per_order.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::galerkin {

namespace {

// Legendre coefficients, degrees 0..order, of the data along one boundary edge, in the direction of its element.
Eigen::MatrixX2d project(const BoundaryEdge& edge, int order, const curve::ArcLength& arc_length,
                         const BoundaryData& data) {
  static spectral::PerOrder<spectral::Quadrature> rules(
      [](int n) { return spectral::gauss_legendre(n + 10); });  // the data are not polynomial
  const spectral::Quadrature& rule = rules[order];
  const double begin = arc_length.at(edge.t0), length = arc_length.at(edge.t1) - begin;
  Eigen::MatrixX2d coefs = Eigen::MatrixX2d::Zero(num_trace_modes(order), 2);
  Eigen::VectorXd modes(num_trace_modes(order));
  for (std::size_t q = 0; q < rule.points.size(); ++q) {
    const Vec2 value = data(edge.curve, arc_length.parameter(begin + (1 + rule.points[q]) / 2 * length));
    trace_values(order, rule.points[q], modes.data());
    coefs += rule.weights[q] * modes * Eigen::RowVector2d(value.x, value.y);
  }
  return coefs;
}

}  // namespace

Eigen::MatrixXd trace_data(const TriMesh& mesh, const mesh::TriTopology& topology, const DofMap& map,
                           const BoundaryData& data) {
  std::vector<std::unique_ptr<curve::ArcLength>> arc_lengths(mesh.face.num_curves());
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(map.num_dofs - map.num_unknowns, 2);
  for (const BoundaryEdge& boundary_edge : mesh.boundary_edges) {
    auto& arc_length = arc_lengths[boundary_edge.curve];
    if (!arc_length) arc_length = std::make_unique<curve::ArcLength>(mesh.face.curves[boundary_edge.curve]);
    const auto& vertices = mesh.elem2vertices[boundary_edge.elem];
    const int edge = topology.elem2edges[boundary_edge.elem][boundary_edge.edge], order = map.edge2order[edge];
    Eigen::MatrixX2d coefs = project(boundary_edge, order, *arc_length, data);
    if (vertices[boundary_edge.edge] >
        vertices[(boundary_edge.edge + 1) % 3]) {  // the direction of the edge is opposite
      for (int d = 1; d <= order; d += 2) coefs.row(d) *= -1;
    }
    values.middleRows(map.edge2dof[edge] - map.num_unknowns, order + 1) = coefs;
  }
  return values;
}

}  // namespace quadrille::galerkin
