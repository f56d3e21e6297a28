#include "chart/element_forms.hpp"

#include <array>
#include <cmath>

#include "base/angle.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::chart {
namespace {

using Vectors = Eigen::Matrix<double, Eigen::Dynamic, 3>;  // one a row

/// Of each vertex: the direction in space of the x axis of the image, by the straight triangles around it.
std::vector<Vec3> vertex_directions(const SurfaceMesh& mesh) {
  std::vector<Vec3> directions(mesh.plane.vertices.size());
  for (int e = 0; e < mesh.num_elems(); ++e) {
    const std::array<int, 3>& v = mesh.plane.elem2vertices[e];
    const Vec3* const x = &mesh.nodes[static_cast<std::size_t>(mesh.nodes_per_elem()) * e];
    const Vec2 a = mesh.plane.vertices[v[1]] - mesh.plane.vertices[v[0]],
               b = mesh.plane.vertices[v[2]] - mesh.plane.vertices[v[0]];
    // d x / d X = (x_a b.y - x_b a.y) / cross(a, b), weighted by the area.
    const Vec3 direction = b.y * (x[1] - x[0]) - a.y * (x[2] - x[0]);
    for (const int k : v) directions[k] += direction;
  }
  for (Vec3& d : directions) d = normalized(d);
  return directions;
}

/// Nodes of one element, a row each.
struct NodalFrame {
  Vectors x, e1, e2;
};

NodalFrame nodal_frame(const SurfaceMesh& mesh, int elem, const std::vector<Vec3>& directions) {
  const int n = mesh.nodes_per_elem();
  const std::vector<Vec2>& xi = spectral::tri_nodes(mesh.order);
  NodalFrame frame{Vectors(n, 3), Vectors(n, 3), Vectors(n, 3)};
  const auto set = [](Vectors& rows, int i, Vec3 a) { rows.row(i) << a.x, a.y, a.z; };
  const std::array<int, 3>& v = mesh.plane.elem2vertices[elem];
  for (int i = 0; i < n; ++i) {
    const std::size_t node = static_cast<std::size_t>(n) * elem + i;
    const Vec3 normal = mesh.normals[node];
    const Vec3 d = (1 - (1 + xi[i].x) / 2 - (1 + xi[i].y) / 2) * directions[v[0]] +
                   (1 + xi[i].x) / 2 * directions[v[1]] + (1 + xi[i].y) / 2 * directions[v[2]];
    const Vec3 e1 = normalized(d - dot(d, normal) * normal);
    set(frame.x, i, mesh.nodes[node]), set(frame.e1, i, e1), set(frame.e2, i, cross(normal, e1));
  }
  return frame;
}

Eigen::VectorXd products(const Vectors& a, const Vectors& b) { return a.cwiseProduct(b).rowwise().sum(); }

ElementForms forms_of(const ElementTables& tables, const NodalFrame& frame) {
  const Vectors x1 = tables.nodes_xi1 * frame.x, x2 = tables.nodes_xi2 * frame.x;
  const Vectors e1 = tables.from_nodes * frame.e1, e2 = tables.from_nodes * frame.e2;
  const Eigen::ArrayXd g11 = products(x1, x1), g12 = products(x1, x2), g22 = products(x2, x2);
  const Eigen::ArrayXd scale = tables.weights.array() / (g11 * g22 - g12 * g12).sqrt();
  ElementForms forms;
  forms.h11 = scale * g22, forms.h12 = -scale * g12, forms.h22 = scale * g11;
  forms.theta1 = {products(e1, x1), products(e1, x2)};
  forms.theta2 = {products(e2, x1), products(e2, x2)};
  forms.omega = {products(tables.nodes_xi1 * frame.e1, e2), products(tables.nodes_xi2 * frame.e1, e2)};
  return forms;
}

EdgeForms edge_forms(const EdgeTable& table, const NodalFrame& frame) {
  const Vectors x = table.derivative * frame.x, e1 = table.from_nodes * frame.e1, e2 = table.from_nodes * frame.e2;
  EdgeForms forms;
  forms.length = products(x, x).cwiseSqrt().cwiseProduct(table.weights);
  forms.theta1 = products(x, e1).cwiseProduct(table.weights);
  forms.theta2 = products(x, e2).cwiseProduct(table.weights);
  forms.omega = products(table.derivative * frame.e1, e2).cwiseProduct(table.weights);
  return forms;
}

}  // namespace

SurfaceForms surface_forms(const SurfaceMesh& mesh, const std::vector<int>& loop_offsets) {
  const ElementTables& tables = element_tables(mesh.order);
  const std::vector<Vec3> directions = vertex_directions(mesh);
  SurfaceForms forms;
  for (int e = 0; e < mesh.num_elems(); ++e) forms.elems.push_back(forms_of(tables, nodal_frame(mesh, e, directions)));
  forms.hole_lengths.assign(loop_offsets.size() - 1, 0);
  int loop = 0;
  for (const BoundaryEdge& b : mesh.plane.boundary_edges) {
    while (b.curve >= loop_offsets[loop + 1]) ++loop;
    if (loop == 0) continue;
    EdgeForms edge = edge_forms(tables.edges[b.edge], nodal_frame(mesh, b.elem, directions));
    edge.elem = b.elem, edge.edge = b.edge, edge.hole = loop;
    const double length = edge.length.sum();
    edge.turn = forms.hole_lengths[loop] + length * (1 + tables.edges[b.edge].points.array()) / 2;
    forms.hole_lengths[loop] += length;
    forms.hole_edges.push_back(std::move(edge));
  }
  for (EdgeForms& edge : forms.hole_edges) edge.turn *= 2 * pi / forms.hole_lengths[edge.hole];
  return forms;
}

Eigen::MatrixXd products_with_gradients(const ElementTables& tables, const ElementForms& elem, const OneForm& form) {
  const Eigen::MatrixXd a = elem.h11.asDiagonal() * form.xi1 + elem.h12.asDiagonal() * form.xi2,
                        b = elem.h12.asDiagonal() * form.xi1 + elem.h22.asDiagonal() * form.xi2;
  return tables.modes_xi1.transpose() * a + tables.modes_xi2.transpose() * b;
}

// form ^ dq = (form_1 q_2 - form_2 q_1) dxi1 dxi2.
Eigen::MatrixXd wedges_with_gradients(const ElementTables& tables, const OneForm& form) {
  return tables.modes_xi2.transpose() * (tables.weights.asDiagonal() * form.xi1) -
         tables.modes_xi1.transpose() * (tables.weights.asDiagonal() * form.xi2);
}

double square(const ElementForms& elem, const OneForm& form) {
  const auto of = [](const Eigen::VectorXd& h, const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
    return (h.asDiagonal() * a.cwiseProduct(b)).sum();
  };
  return of(elem.h11, form.xi1, form.xi1) + 2 * of(elem.h12, form.xi1, form.xi2) + of(elem.h22, form.xi2, form.xi2);
}

Eigen::MatrixXd stiffness_matrix(const ElementTables& tables, const ElementForms& elem) {
  return products_with_gradients(tables, elem, {tables.modes_xi1, tables.modes_xi2});
}

}  // namespace quadrille::chart
