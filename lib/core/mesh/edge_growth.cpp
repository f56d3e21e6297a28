#include "mesh/edge_growth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace quadrille::mesh {
namespace {

constexpr double equal_tol = 1e-6;

/// An edge at one end of an edge that two elements may share.
struct Beside {
  int vertex = 0;     ///< the common vertex
  double length = 0;  ///< from there along the element's next edge
};

int vertex(const QuadMesh& mesh, int elem, int k) {
  const int n = mesh.order, width = n + 1;
  const std::array<int, 4> corner{0, n, width * width - 1, width * n};
  return mesh.elem_nodes[static_cast<std::size_t>(elem) * width * width + corner[k % 4]];
}

/// At both ends of side k, the element's edges that continue a line across it; the lower vertex first.
std::array<Beside, 2> beside_side(const QuadMesh& mesh, int elem, int k) {
  const auto at = [&](int corner, int next) -> Beside {
    const int v = vertex(mesh, elem, corner);
    return {v, distance(mesh.nodes[v], mesh.nodes[vertex(mesh, elem, next)])};
  };
  std::array<Beside, 2> both{at(k, k + 3), at(k + 1, k + 2)};
  if (both[1].vertex < both[0].vertex) std::swap(both[0], both[1]);
  return both;
}

}  // namespace

EdgeGrowth edge_growth(const QuadMesh& mesh, double limit) {
  EdgeGrowth growth;
  std::map<std::pair<int, int>, std::array<Beside, 2>> open;  // sides met once
  for (int elem = 0; elem < mesh.num_elems(); ++elem)
    for (int k = 0; k < 4; ++k) {
      const std::array<Beside, 2> own = beside_side(mesh, elem, k);
      const auto [it, is_new] = open.try_emplace({own[0].vertex, own[1].vertex}, own);
      if (is_new) continue;
      for (const int end : {0, 1}) {
        const double a = own[end].length, b = it->second[end].length, ratio = std::max(a / b, b / a);
        if (ratio > limit) growth.excess += std::pow(std::log(ratio / limit), 2);
        if (ratio <= growth.greatest * (1 + equal_tol)) continue;
        growth.greatest = ratio;
        growth.position = mesh.nodes[own[end].vertex];
      }
      open.erase(it);
    }
  return growth;
}

}  // namespace quadrille::mesh
