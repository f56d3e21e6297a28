#include "export/side_blend.hpp"

#include <algorithm>

#include "export/transfinite_loss.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::exports {

double distance_from_side_blend(const QuadMesh& mesh, int elem) {
  const int count = mesh.nodes_per_elem();
  std::vector<Vec2> ours;
  for (int k = 0; k < count; ++k) ours.push_back(mesh.nodes[mesh.elem_nodes[elem * count + k]]);
  const std::vector<Vec2> blend = transfinite_element(mesh.order, ours.data());
  double largest = 0;
  for (int k = 0; k < count; ++k) largest = std::max(largest, distance(blend[k], ours[k]));
  return largest;
}

double distance_from_chord(const QuadMesh& mesh, const std::vector<int>& edge_nodes) {
  const std::vector<double>& points = spectral::gll_points(mesh.order);
  const Vec2 start = mesh.nodes[edge_nodes.front()], end = mesh.nodes[edge_nodes.back()];
  double largest = 0;
  for (int k = 1; k < mesh.order; ++k) {
    const double s = (1 + points[k]) / 2;
    largest = std::max(largest, distance((1 - s) * start + s * end, mesh.nodes[edge_nodes[k]]));
  }
  return largest;
}

}  // namespace quadrille::exports
