#include "mesh/quality.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/angle.hpp"

namespace quadrille::mesh {

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
