#include "galerkin/dirichlet.hpp"

#include <utility>

#include "spectral/modified_basis.hpp"
#include "spectral/per_order.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::galerkin {

namespace {

// Maps data at Gauss points, minus the linear function through the ends, to the coefficients of the edge modes: row d -
// 2 for degree d. With psi_d' = -P_{d-1} (norm 1) the projection is c_d = int g' psi_d' = -int g psi_d'', and psi_d''
// is known from psi_d by Legendre's equation: ((1 - s^2) P')' = -d (d - 1) P, so -psi_d'' = d (d - 1) psi_d / (1 -
// s^2), a polynomial of degree d - 2. With P + 4 points all coefficients are exact for data of degree up to P + 9, so
// that the quadrature adds less than the projection omits.
struct EdgeProjection {
  std::vector<double> points;
  Eigen::MatrixXd matrix;
};

EdgeProjection make_projection(int order) {
  const spectral::Quadrature rule = spectral::gauss_legendre(order + 4);
  const int n = static_cast<int>(rule.points.size());
  EdgeProjection projection{rule.points, Eigen::MatrixXd(order - 1, n)};
  for (int i = 0; i < n; ++i) {
    const double s = rule.points[i];
    spectral::edge_mode_values(order, s, projection.matrix.col(i).data());
    for (int d = 2; d <= order; ++d) projection.matrix(d - 2, i) *= rule.weights[i] * d * (d - 1) / (1 - s * s);
  }
  return projection;
}

const EdgeProjection& edge_projection(int order) {
  static spectral::PerOrder<EdgeProjection> tables(make_projection);
  return tables[order];
}

// Calls f(first, last) for the boundary edges [first, last) of each curve.
template <class F>
void for_each_curve(const TriMesh& mesh, F&& f) {
  const std::vector<BoundaryEdge>& edges = mesh.boundary_edges;
  const int num_edges = static_cast<int>(edges.size());
  for (int first = 0, last = 0; first < num_edges; first = last) {
    while (last < num_edges && edges[last].curve == edges[first].curve) ++last;
    f(first, last);
  }
}

}  // namespace

BoundaryPoints::BoundaryPoints(const TriMesh& mesh)
    : mesh_(&mesh), arc_lengths_(mesh.face.num_curves()), edges_(mesh.boundary_edges.size()) {}

const std::vector<double>& BoundaryPoints::parameters(int b, int order) {
  Edge& edge = edges_[b];
  if (edge.order == order) return edge.parameters;
  const BoundaryEdge& boundary_edge = mesh_->boundary_edges[b];
  auto& arc_length = arc_lengths_[boundary_edge.curve];
  if (!arc_length) arc_length = std::make_unique<curve::ArcLength>(mesh_->face.curves[boundary_edge.curve]);
  const double begin = arc_length->at(boundary_edge.t0), length = arc_length->at(boundary_edge.t1) - begin;
  edge.parameters.clear();
  for (const double s : edge_projection(order).points)
    edge.parameters.push_back(arc_length->parameter(begin + (1 + s) / 2 * length));
  edge.order = order;
  return edge.parameters;
}

DirichletData::DirichletData(const TriMesh& mesh, BoundaryData data)
    : DirichletData(std::make_shared<BoundaryPoints>(mesh), std::move(data)) {}

DirichletData::DirichletData(std::shared_ptr<BoundaryPoints> points, BoundaryData data)
    : DirichletData(std::move(points), 2,
                    [data = std::move(data)](int curve, std::span<const double> t, double* values) {
                      for (const double at : t) {
                        const Vec2 value = data(curve, at);
                        *values++ = value.x;
                        *values++ = value.y;
                      }
                    }) {}

DirichletData::DirichletData(std::shared_ptr<BoundaryPoints> points, BoundaryScalars data)
    : DirichletData(std::move(points), 1, std::move(data)) {}

DirichletData::DirichletData(std::shared_ptr<BoundaryPoints> points, int num_columns, Sampler sampler)
    : points_(std::move(points)),
      num_columns_(num_columns),
      sampler_(std::move(sampler)),
      edges_(points_->mesh().boundary_edges.size()) {
  for_each_curve(points_->mesh(), [&](int first, int last) { sample_ends(first, last); });
}

DirichletData::Samples DirichletData::at(int curve, std::span<const double> t) const {
  Samples values(t.size(), num_columns_);
  sampler_(curve, t, values.data());
  return values;
}

// Of the edges [first, last) of one curve.
void DirichletData::sample_ends(int first, int last) {
  const std::vector<BoundaryEdge>& boundary_edges = points_->mesh().boundary_edges;
  std::vector<double> t;
  for (int b = first; b < last; ++b) {
    for (const double end : {boundary_edges[b].t0, boundary_edges[b].t1})
      if (t.empty() || t.back() != end) t.push_back(end);
  }
  const Samples values = at(boundary_edges[first].curve, t);
  for (int b = first, i = 0; b < last; ++b) {
    i += t[i] != boundary_edges[b].t0;
    edges_[b].first = values.row(i);
    edges_[b].last = values.row(++i);
  }
}

// For edges of one curve: their points are sampled together.
void DirichletData::project(const std::vector<int>& edges, const std::vector<int>& orders) {
  std::vector<double> t;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const std::vector<double>& parameters = points_->parameters(edges[i], orders[i]);
    t.insert(t.end(), parameters.begin(), parameters.end());
  }
  const Samples values = at(points_->mesh().boundary_edges[edges.front()].curve, t);
  int row = 0;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    Edge& edge = edges_[edges[k]];
    const EdgeProjection& projection = edge_projection(orders[k]);
    Eigen::MatrixXd bubble(projection.points.size(), num_columns_);
    for (int i = 0; i < bubble.rows(); ++i, ++row) {
      const double f = (1 + projection.points[i]) / 2;
      bubble.row(i) = values.row(row) - (1 - f) * edge.first - f * edge.last;
    }
    edge.coefs = projection.matrix * bubble;
    edge.order = orders[k];
  }
}

void DirichletData::update_projections(const mesh::TriTopology& topology, const DofMap& map) {
  for_each_curve(points_->mesh(), [&](int first, int last) {
    std::vector<int> changed, orders;
    for (int b = first; b < last; ++b) {
      const BoundaryEdge& boundary_edge = points_->mesh().boundary_edges[b];
      const int order = map.edge2order[topology.elem2edges[boundary_edge.elem][boundary_edge.edge]];
      if (order < 2 || edges_[b].order == spectral::table_order(order)) continue;
      changed.push_back(b);
      orders.push_back(spectral::table_order(order));
    }
    if (!changed.empty()) project(changed, orders);
  });
}

Eigen::MatrixXd DirichletData::values(const mesh::TriTopology& topology, const DofMap& map) {
  const TriMesh& mesh = points_->mesh();
  update_projections(topology, map);
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(map.num_dofs - map.num_unknowns, num_columns_);
  for (std::size_t b = 0; b < edges_.size(); ++b) {
    const BoundaryEdge& boundary_edge = mesh.boundary_edges[b];
    const auto& vertices = mesh.elem2vertices[boundary_edge.elem];
    const int vertex0 = vertices[boundary_edge.edge], vertex1 = vertices[(boundary_edge.edge + 1) % 3];
    values.row(map.vertex2dof[vertex0] - map.num_unknowns) = edges_[b].first;
    const int edge = topology.elem2edges[boundary_edge.elem][boundary_edge.edge], order = map.edge2order[edge];
    if (order < 2) continue;
    Eigen::MatrixXd coefs = edges_[b].coefs.topRows(order - 1);
    if (vertex0 > vertex1) {  // the direction of the edge is opposite: odd degrees change sign
      for (int d = 3; d <= order; d += 2) coefs.row(d - 2) *= -1;
    }
    values.middleRows(map.edge2dof[edge] - map.num_unknowns, order - 1) = coefs;
  }
  return values;
}

}  // namespace quadrille::galerkin
