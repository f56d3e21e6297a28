#include "export/renode.hpp"

#include "model/quad_mesh.hpp"

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

}  // namespace quadrille::exports
