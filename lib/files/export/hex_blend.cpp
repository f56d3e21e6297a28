#include "export/hex_blend.hpp"

#include <algorithm>

#include "spectral/quadrature.hpp"

namespace quadrille::exports {

namespace {

/// x - P x along the axis with this stride.
void subtract_linear(const std::vector<double>& points, int stride, std::vector<Vec3>& values) {
  const int width = static_cast<int>(points.size()), count = static_cast<int>(values.size());
  for (int first = 0; first < count; ++first) {
    if (first / stride % width != 0) continue;
    const Vec3 low = values[first], high = values[first + (width - 1) * stride];
    for (int k = 0; k < width; ++k) {
      const double s = (1 + points[k]) / 2;
      Vec3& value = values[first + k * stride];
      value = value - ((1 - s) * low + s * high);
    }
  }
}

/// The shortest line between neighbouring corners.
double shortest_line(const HexMesh& mesh, const std::vector<int>& nodes) {
  const int n = mesh.order, width = n + 1, count = static_cast<int>(nodes.size());
  double shortest = mesh.diameter;
  for (int stride = 1; stride < count; stride *= width)
    for (int first = 0; first < count; ++first) {
      bool is_corner = true;
      for (int s = 1; s < count; s *= width) is_corner = is_corner && first / s % width % n == 0;
      if (is_corner && first / stride % width == 0)
        shortest = std::min(shortest, distance(mesh.nodes[nodes[first]], mesh.nodes[nodes[first + n * stride]]));
    }
  return shortest;
}

}  // namespace

double blend_distance(const HexMesh& mesh, const std::vector<int>& nodes) {
  const std::vector<double>& points = spectral::gll_points(mesh.order);
  std::vector<Vec3> values;
  for (const int node : nodes) values.push_back(mesh.nodes[node]);
  for (int stride = 1; stride < static_cast<int>(nodes.size()); stride *= mesh.order + 1)
    subtract_linear(points, stride, values);
  double largest = 0;
  for (const Vec3 value : values) largest = std::max(largest, norm(value));
  return largest;
}

bool is_blend(const HexMesh& mesh, const std::vector<int>& nodes) {
  return blend_distance(mesh, nodes) <= std::max(1e-10 * shortest_line(mesh, nodes), 1e-14 * mesh.diameter);
}

double face_blend_loss(const HexMesh& mesh) {
  double largest = 0;
  const int count = mesh.nodes_per_elem();
  for (auto first = mesh.elem_nodes.begin(); first != mesh.elem_nodes.end(); first += count)
    largest = std::max(largest, blend_distance(mesh, {first, first + count}));
  return largest;
}

}  // namespace quadrille::exports
