#include "galerkin/phase_orders.hpp"

#include <algorithm>

namespace quadrille::galerkin {

std::vector<int> phase_orders(const TriMesh& mesh, const std::vector<int>& field_orders) {
  constexpr int more_than_half = 5;
  std::vector<int> orders = field_orders;
  for (std::size_t e = 0; e < orders.size(); ++e)
    if (mesh.elem_layer[e] < 0) orders[e] = std::min(orders[e], (orders[e] + 1) / 2 + more_than_half);
  for (const BoundaryEdge& edge : mesh.boundary_edges)
    if (mesh.face.curves[edge.curve].degree == 1) orders[edge.elem] = field_orders[edge.elem];
  return orders;
}

}  // namespace quadrille::galerkin
