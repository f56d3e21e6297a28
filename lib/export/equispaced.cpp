#include "export/equispaced.hpp"

#include "export/skeleton.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille {
namespace {

Eigen::MatrixXd to_equispaced(int order) {
  std::vector<double> points;
  for (int i = 0; i <= order; ++i) points.push_back(-1 + 2.0 * i / order);
  return interpolation_matrix(gll_points(order), points);
}

void move_edge(const QuadMesh& mesh, const Eigen::MatrixXd& basis, const std::vector<int>& edge,
               std::vector<Vec2>& moved) {
  for (int i = 1; i < mesh.order; ++i) {
    Vec2 sum;
    for (int k = 0; k <= mesh.order; ++k) sum += basis(i, k) * mesh.nodes[edge[k]];
    moved[edge[i]] = sum;
  }
}

void move_inside(const QuadMesh& mesh, const Eigen::MatrixXd& basis, const int* ids, std::vector<Vec2>& moved) {
  const int n = mesh.order, width = n + 1;
  std::vector<Vec2> half(width * width);
  for (int b = 0; b <= n; ++b)
    for (int i = 1; i < n; ++i)
      for (int a = 0; a <= n; ++a) half[b * width + i] += basis(i, a) * mesh.nodes[ids[b * width + a]];
  for (int j = 1; j < n; ++j)
    for (int i = 1; i < n; ++i) {
      Vec2 sum;
      for (int b = 0; b <= n; ++b) sum += basis(j, b) * half[b * width + i];
      moved[ids[j * width + i]] = sum;
    }
}

}  // namespace

std::vector<Vec2> equispaced_nodes(const QuadMesh& mesh) {
  std::vector<Vec2> moved = mesh.nodes;
  if (mesh.order <= 2) return moved;  // the same points
  const Eigen::MatrixXd basis = to_equispaced(mesh.order);
  std::vector<bool> done(mesh.nodes.size(), false);  // by the first inner node of an edge
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    for (int side = 0; side < 4; ++side) {
      const std::vector<int> edge = side_nodes(mesh, elem, side);
      if (done[edge[1]] || done[edge[mesh.order - 1]]) continue;
      done[edge[1]] = true;
      move_edge(mesh, basis, edge, moved);
    }
    move_inside(mesh, basis, &mesh.elem_nodes[elem * mesh.nodes_per_elem()], moved);
  }
  return moved;
}

}  // namespace quadrille
