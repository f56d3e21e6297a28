#include "export/side_blend.hpp"

#include <algorithm>

#include "spectral/quadrature.hpp"

namespace quadrille {

double distance_from_side_blend(const QuadMesh& mesh, int elem) {
  const int n = mesh.order;
  const int* ids = &mesh.elem_nodes[elem * mesh.nodes_per_elem()];
  const auto at = [&](int i, int j) { return mesh.nodes[ids[j * (n + 1) + i]]; };
  const std::vector<double>& points = gll_points(n);
  double largest = 0;
  for (int j = 1; j < n; ++j)
    for (int i = 1; i < n; ++i) {
      const double s = (1 + points[i]) / 2, t = (1 + points[j]) / 2;
      const Vec2 blend = (1 - t) * (at(i, 0) - (1 - s) * at(0, 0) - s * at(n, 0)) +
                         t * (at(i, n) - (1 - s) * at(0, n) - s * at(n, n)) + (1 - s) * at(0, j) + s * at(n, j);
      largest = std::max(largest, distance(blend, at(i, j)));
    }
  return largest;
}

double distance_from_chord(const QuadMesh& mesh, const std::vector<int>& edge_nodes) {
  const std::vector<double>& points = gll_points(mesh.order);
  const Vec2 start = mesh.nodes[edge_nodes.front()], end = mesh.nodes[edge_nodes.back()];
  double largest = 0;
  for (int k = 1; k < mesh.order; ++k) {
    const double s = (1 + points[k]) / 2;
    largest = std::max(largest, distance((1 - s) * start + s * end, mesh.nodes[edge_nodes[k]]));
  }
  return largest;
}

}  // namespace quadrille
