#include "mesh/tri_maps.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/angle.hpp"
#include "spectral/orthogonal_basis.hpp"

namespace quadrille::mesh {

std::vector<spectral::TriMap> tri_maps(const TriMesh& mesh) {
  std::vector<spectral::TriMap> maps;
  maps.reserve(mesh.elem2vertices.size());
  const int num_nodes = spectral::num_tri_modes(mesh.order);
  std::size_t next_curved = 0;
  for (int e = 0; e < mesh.num_elems(); ++e) {
    if (next_curved < mesh.curved_elems.size() && mesh.curved_elems[next_curved] == e) {
      maps.emplace_back(mesh.order, &mesh.curved_nodes[next_curved * num_nodes]);
      ++next_curved;
    } else {
      const auto& [a, b, c] = mesh.elem2vertices[e];
      maps.emplace_back(std::array<Vec2, 3>{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
    }
  }
  return maps;
}

double least_angle(const TriMesh& mesh) {
  double least = pi;
  for (const auto& elem : mesh.elem2vertices) {
    for (int k = 0; k < 3; ++k) {
      const Vec2 a = mesh.vertices[elem[(k + 1) % 3]] - mesh.vertices[elem[k]];
      const Vec2 b = mesh.vertices[elem[(k + 2) % 3]] - mesh.vertices[elem[k]];
      least = std::min(least, std::atan2(cross(a, b), dot(a, b)));
    }
  }
  return least;
}

double least_edge_ratio(const TriMesh& mesh) {
  double least = 1;
  for (const auto& elem : mesh.elem2vertices) {
    std::array<double, 3> lengths{};
    for (int k = 0; k < 3; ++k) lengths[k] = distance(mesh.vertices[elem[k]], mesh.vertices[elem[(k + 1) % 3]]);
    const auto [low, high] = std::minmax_element(lengths.begin(), lengths.end());
    least = std::min(least, *low / *high);
  }
  return least;
}

}  // namespace quadrille::mesh
