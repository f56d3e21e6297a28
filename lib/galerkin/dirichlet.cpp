#include "galerkin/dirichlet.hpp"

#include <memory>

#include "curve/arc_length.hpp"
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

// Coefficients of the boundary edge's modes, walked as the element walks it, from its end values and the data between.
Eigen::MatrixX2d project_edge(const BoundaryEdge& b, const ArcLength& arc_length, int order, const BoundaryData& data,
                              const Eigen::RowVector2d& first, const Eigen::RowVector2d& last) {
  const double begin = arc_length.at(b.t0), length = arc_length.at(b.t1) - begin;
  const EdgeProjection& projection = edge_projection(order);
  const int n = static_cast<int>(projection.points.size());
  Eigen::MatrixX2d bubble(n, 2);
  for (int i = 0; i < n; ++i) {
    const double f = (1 + projection.points[i]) / 2;
    bubble.row(i) = row(data(b.curve, arc_length.parameter(begin + f * length))) - (1 - f) * first - f * last;
  }
  return projection.matrix * bubble;
}

}  // namespace

Eigen::MatrixX2d dirichlet_values(const TriMesh& mesh, const TriTopology& topology, const DofMap& map,
                                  const BoundaryData& data) {
  std::vector<std::unique_ptr<ArcLength>> arc_lengths(mesh.face.num_curves());
  Eigen::MatrixX2d values = Eigen::MatrixX2d::Zero(map.num_dofs - map.num_unknowns, 2);
  for (const BoundaryEdge& b : mesh.boundary_edges) {
    const Eigen::RowVector2d first = row(data(b.curve, b.t0)), last = row(data(b.curve, b.t1));
    const int vertex0 = mesh.elem2vertices[b.elem][b.edge], vertex1 = mesh.elem2vertices[b.elem][(b.edge + 1) % 3];
    values.row(map.vertex2dof[vertex0] - map.num_unknowns) = first;
    const int edge = topology.elem2edges[b.elem][b.edge], order = map.edge2order[edge];
    if (order < 2) continue;
    if (!arc_lengths[b.curve]) arc_lengths[b.curve] = std::make_unique<ArcLength>(mesh.face.curves[b.curve]);
    Eigen::MatrixX2d coefs = project_edge(b, *arc_lengths[b.curve], order, data, first, last);
    if (vertex0 > vertex1) {  // the edge's own direction is the other one: odd degrees change sign
      for (int d = 3; d <= order; d += 2) coefs.row(d - 2) *= -1;
    }
    values.middleRows(map.edge2dof[edge] - map.num_unknowns, order - 1) = coefs;
  }
  return values;
}

}  // namespace quadrille
