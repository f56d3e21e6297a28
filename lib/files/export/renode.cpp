#include "export/renode.hpp"

#include <cmath>
#include <numbers>

#include "model/quad_mesh.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::exports {

namespace {

void move_edge(const QuadMesh& mesh, const Eigen::MatrixXd& from_gll, const std::vector<int>& edge,
               std::vector<Vec2>& moved) {
  for (int i = 1; i < mesh.order; ++i) {
    Vec2 sum;
    for (int k = 0; k <= mesh.order; ++k) sum += from_gll(i, k) * mesh.nodes[edge[k]];
    moved[edge[i]] = sum;
  }
}

void move_inside(const QuadMesh& mesh, const Eigen::MatrixXd& from_gll, const int* ids, std::vector<Vec2>& moved) {
  const int n = mesh.order, width = n + 1;
  std::vector<Vec2> half(width * width);
  for (int b = 0; b <= n; ++b)
    for (int i = 1; i < n; ++i)
      for (int a = 0; a <= n; ++a) half[b * width + i] += from_gll(i, a) * mesh.nodes[ids[b * width + a]];
  for (int j = 1; j < n; ++j)
    for (int i = 1; i < n; ++i) {
      Vec2 sum;
      for (int b = 0; b <= n; ++b) sum += from_gll(j, b) * half[b * width + i];
      moved[ids[j * width + i]] = sum;
    }
}

/// Row i: the Bernstein polynomials of degree N at Gauss-Lobatto-Legendre point i.
Eigen::MatrixXd bernstein_at_gll(int order) {
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(order + 1, order + 1);
  for (int i = 0; i <= order; ++i) {
    const double t = (1 + spectral::gll_points(order)[i]) / 2;
    values(i, 0) = 1;
    for (int degree = 1; degree <= order; ++degree)  // de Casteljau's triangle
      for (int k = degree; k >= 0; --k) values(i, k) = (1 - t) * values(i, k) + (k > 0 ? t * values(i, k - 1) : 0.0);
  }
  return values;
}

}  // namespace

std::vector<Vec2> renoded(const QuadMesh& mesh, const Eigen::MatrixXd& from_gll) {
  std::vector<Vec2> moved = mesh.nodes;
  if (mesh.order == 1) return moved;
  std::vector<bool> done(mesh.nodes.size(), false);  // by the first inner node of an edge
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    for (int side = 0; side < 4; ++side) {
      const std::vector<int> edge = side_nodes(mesh, elem, side);
      if (done[edge[1]] || done[edge[mesh.order - 1]]) continue;
      done[edge[1]] = true;
      move_edge(mesh, from_gll, edge, moved);
    }
    move_inside(mesh, from_gll, &mesh.elem_nodes[elem * mesh.nodes_per_elem()], moved);
  }
  return moved;
}

std::vector<Vec2> bezier_points(const QuadMesh& mesh) { return renoded(mesh, bernstein_at_gll(mesh.order).inverse()); }

std::vector<Vec2> equispaced_nodes(const QuadMesh& mesh) {
  if (mesh.order <= 2) return mesh.nodes;  // the same points
  std::vector<double> points;
  for (int i = 0; i <= mesh.order; ++i) points.push_back(-1 + 2.0 * i / mesh.order);
  return renoded(mesh, spectral::interpolation_matrix(spectral::gll_points(mesh.order), points));
}

std::vector<double> chebyshev_lobatto_points(int order) {
  std::vector<double> points;
  for (int j = 0; j <= order; ++j) points.push_back(std::sin(std::numbers::pi * (2 * j - order) / (2 * order)));
  return points;
}

}  // namespace quadrille::exports
