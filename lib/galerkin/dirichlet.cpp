#include "galerkin/dirichlet.hpp"

#include <utility>

#include "spectral/modified_basis.hpp"
#include "spectral/per_order.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille {

namespace {

// Coefficients of the edge modes from data at Gauss points, less the linear function through the ends: row d - 2.
// With psi_d' = -P_{d-1} (norm 1) the projection is c_d = int g' psi_d' = -int g psi_d'', and psi_d'' is known from
// psi_d by Legendre's equation: ((1 - s^2) P')' = -d (d - 1) P, so -psi_d'' = d (d - 1) psi_d / (1 - s^2).
struct EdgeProjection {
  std::vector<double> points;
  Eigen::MatrixXd matrix;
};

EdgeProjection make_projection(int order) {
  const Quadrature rule = gauss_legendre(order + 10);
  const int n = static_cast<int>(rule.points.size());
  EdgeProjection projection{rule.points, Eigen::MatrixXd(order - 1, n)};
  for (int i = 0; i < n; ++i) {
    const double s = rule.points[i];
    edge_mode_values(order, s, projection.matrix.col(i).data());
    for (int d = 2; d <= order; ++d) projection.matrix(d - 2, i) *= rule.weights[i] * d * (d - 1) / (1 - s * s);
  }
  return projection;
}

const EdgeProjection& edge_projection(int order) {
  static PerOrder<EdgeProjection> tables(make_projection);
  return tables[order];
}

Eigen::RowVector2d row(Vec2 a) { return {a.x, a.y}; }

}  // namespace

DirichletData::DirichletData(const TriMesh& mesh, BoundaryData data)
    : mesh_(&mesh), data_(std::move(data)), arc_lengths_(mesh.face.num_curves()), edges_(mesh.boundary_edges.size()) {
  for (std::size_t b = 0; b < edges_.size(); ++b) {
    const BoundaryEdge& boundary_edge = mesh.boundary_edges[b];
    edges_[b].first = row(data_(boundary_edge.curve, boundary_edge.t0));
    edges_[b].last = row(data_(boundary_edge.curve, boundary_edge.t1));
  }
}

void DirichletData::project(const BoundaryEdge& boundary_edge, int order, Edge& edge) {
  const int curve = boundary_edge.curve;
  if (!arc_lengths_[curve]) arc_lengths_[curve] = std::make_unique<ArcLength>(mesh_->face.curves[curve]);
  const ArcLength& arc_length = *arc_lengths_[curve];
  const double begin = arc_length.at(boundary_edge.t0), length = arc_length.at(boundary_edge.t1) - begin;
  const EdgeProjection& projection = edge_projection(order);
  const int n = static_cast<int>(projection.points.size());
  Eigen::MatrixX2d bubble(n, 2);
  for (int i = 0; i < n; ++i) {
    const double f = (1 + projection.points[i]) / 2;
    const double t = arc_length.parameter(begin + f * length);
    bubble.row(i) = row(data_(curve, t)) - (1 - f) * edge.first - f * edge.last;
  }
  edge.coefs = projection.matrix * bubble;
  edge.order = order;
}

Eigen::MatrixX2d DirichletData::values(const TriTopology& topology, const DofMap& map) {
  Eigen::MatrixX2d values = Eigen::MatrixX2d::Zero(map.num_dofs - map.num_unknowns, 2);
  for (std::size_t b = 0; b < edges_.size(); ++b) {
    const BoundaryEdge& boundary_edge = mesh_->boundary_edges[b];
    const auto& vertices = mesh_->elem2vertices[boundary_edge.elem];
    const int vertex0 = vertices[boundary_edge.edge], vertex1 = vertices[(boundary_edge.edge + 1) % 3];
    values.row(map.vertex2dof[vertex0] - map.num_unknowns) = edges_[b].first;
    const int edge = topology.elem2edges[boundary_edge.elem][boundary_edge.edge], order = map.edge2order[edge];
    if (order < 2) continue;
    if (edges_[b].order != table_order(order)) project(boundary_edge, table_order(order), edges_[b]);
    Eigen::MatrixX2d coefs = edges_[b].coefs.topRows(order - 1);
    if (vertex0 > vertex1) {  // the edge's own direction is the other one: odd degrees change sign
      for (int d = 3; d <= order; d += 2) coefs.row(d - 2) *= -1;
    }
    values.middleRows(map.edge2dof[edge] - map.num_unknowns, order - 1) = coefs;
  }
  return values;
}

}  // namespace quadrille
