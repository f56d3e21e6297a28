#include "triangulate/curve_elements.hpp"

#include <algorithm>

#include "spectral/lagrange.hpp"
#include "spectral/orthogonal_basis.hpp"
#include "spectral/quadrature.hpp"
#include "spectral/tri_bernstein.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::triangulate {
namespace {

using Vertices = std::array<Vec2, 3>;

std::array<double, 3> barycentric(Vec2 xi) { return {-(xi.x + xi.y) / 2, (1 + xi.x) / 2, (1 + xi.y) / 2}; }

/// For each local edge: displacements of the edge's inner nodes -> displacements of all nodes.
std::array<Eigen::MatrixXd, 3> edge_extensions(int order) {
  const auto& gll = spectral::gll_points(order);
  const std::vector<double> inner(gll.begin() + 1, gll.end() - 1);
  const auto& nodes = spectral::tri_nodes(order);
  std::array<Eigen::MatrixXd, 3> extensions;
  for (int edge = 0; edge < 3; ++edge) {
    std::vector<double> along;
    for (const Vec2 xi : nodes) {
      const auto lambda = barycentric(xi);
      along.push_back(lambda[(edge + 1) % 3] - lambda[edge]);
    }
    Eigen::MatrixXd& extension = extensions[edge] = spectral::interpolation_matrix(inner, along);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const auto lambda = barycentric(nodes[i]);
      for (std::size_t j = 0; j < inner.size(); ++j)
        extension(i, j) *= lambda[edge] * lambda[(edge + 1) % 3] * 4 / (1 - inner[j] * inner[j]);
    }
  }
  return extensions;
}

Vertices vertices_of(const TriMesh& mesh, int elem) {
  const auto& [a, b, c] = mesh.elem2vertices[elem];
  return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

std::vector<Vec2> straight_nodes(int order, const Vertices& x) {
  std::vector<Vec2> result;
  for (const Vec2 xi : spectral::tri_nodes(order)) {
    const auto lambda = barycentric(xi);
    result.push_back(x[0] + (lambda[1] * (x[1] - x[0]) + lambda[2] * (x[2] - x[0])));
  }
  for (int k = 0; k < 3; ++k) result[k] = x[k];
  return result;
}

/// Displaces the nodes of an element so that local edge `edge` passes through `on_curve`.
void bend(const Eigen::MatrixXd& extension, const Vertices& x, int order, int edge, const std::vector<Vec2>& on_curve,
          std::vector<Vec2>& nodes) {
  const auto& gll = spectral::gll_points(order);
  const Vec2 from = x[edge], to = x[(edge + 1) % 3];
  std::vector<Vec2> displacements;
  for (int j = 1; j < order; ++j) displacements.push_back((on_curve[j - 1] - from) - (1 + gll[j]) / 2 * (to - from));
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (std::size_t j = 0; j < displacements.size(); ++j) nodes[i] += extension(i, j) * displacements[j];
}

std::vector<char> straight_curves(const Outline& outline) {
  std::vector<char> result(outline.face().num_curves(), 0);
  for (const SmoothPiece& piece : outline.pieces()) result[piece.curve] = piece.is_straight;
  return result;
}

}  // namespace

void curve_elements(const EdgeFit& fit, TriMesh& mesh) {
  mesh.curved_elems.clear();
  mesh.curved_nodes.clear();
  if (mesh.order < 2) return;
  const auto is_straight = straight_curves(fit.outline());
  std::vector<const BoundaryEdge*> edges;
  for (const BoundaryEdge& edge : mesh.boundary_edges)
    if (!is_straight[edge.curve]) edges.push_back(&edge);
  std::stable_sort(edges.begin(), edges.end(), [](auto* a, auto* b) { return a->elem < b->elem; });
  const auto extensions = edge_extensions(mesh.order);
  for (std::size_t i = 0; i < edges.size();) {
    const int elem = edges[i]->elem;
    const Vertices x = vertices_of(mesh, elem);
    std::vector<Vec2> nodes = straight_nodes(mesh.order, x);
    std::vector<std::pair<int, Vec2>> exact;
    for (; i < edges.size() && edges[i]->elem == elem; ++i) {
      const auto on_curve = fit.inner_nodes(edges[i]->curve, edges[i]->t0, edges[i]->t1);
      bend(extensions[edges[i]->edge], x, mesh.order, edges[i]->edge, on_curve, nodes);
      for (int j = 1; j < mesh.order; ++j)
        exact.emplace_back(spectral::tri_edge_node(mesh.order, edges[i]->edge, j), on_curve[j - 1]);
    }
    // Replaces the edge nodes by the exact points of the curve.
    for (const auto& [node, position] : exact) nodes[node] = position;
    mesh.curved_elems.push_back(elem);
    mesh.curved_nodes.insert(mesh.curved_nodes.end(), nodes.begin(), nodes.end());
  }
}

std::vector<double> jacobian_ratio_bounds(const TriMesh& mesh) {
  std::vector<double> ratios(mesh.num_elems(), 1.0);
  const int num_nodes = spectral::num_tri_modes(mesh.order);
  for (int e = 0; e < mesh.num_elems(); ++e) {
    const Vertices x = vertices_of(mesh, e);
    if (cross(x[1] - x[0], x[2] - x[0]) <= 0) ratios[e] = -1;
  }
  std::vector<Vec2> local(num_nodes);
  for (std::size_t c = 0; c < mesh.curved_elems.size(); ++c) {
    const int e = mesh.curved_elems[c];
    const Vertices x = vertices_of(mesh, e);
    // Coordinates relative to a vertex: small elements far from the origin keep their significant digits.
    for (int i = 0; i < num_nodes; ++i) local[i] = mesh.curved_nodes[c * num_nodes + i] - x[0];
    const spectral::TriMap map(mesh.order, local.data());
    const auto bx = spectral::bernstein_from_orthogonal(mesh.order, map.coefs_x());
    const auto by = spectral::bernstein_from_orthogonal(mesh.order, map.coefs_y());
    const double straight = cross(x[1] - x[0], x[2] - x[0]) / 4;
    const double bound = spectral::jacobian_lower_bound(mesh.order, bx, by);
    ratios[e] = straight > 0 ? bound / straight : std::min(bound, 0.0) - 1;
  }
  return ratios;
}

}  // namespace quadrille::triangulate
