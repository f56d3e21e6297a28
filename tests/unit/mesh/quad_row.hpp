#pragma once
// Meshes of one row of rectangles, for tests of measures of quad meshes.

#include <algorithm>
#include <vector>

#include "mesh/element_sizes.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::mesh {

/// Rectangles of order N side by side, of which column k is [ends[k], ends[k + 1]] x [0, height]; the sizes of elements
/// are measured, and all are proved valid with a scaled Jacobian of 1.
inline QuadMesh quad_row(int order, const std::vector<double>& ends, double height) {
  QuadMesh mesh;
  mesh.order = order;
  mesh.face.diameter = 1;
  const std::vector<double>& points = spectral::gll_points(order);
  const int columns = static_cast<int>(ends.size()) - 1, width = columns * order + 1;
  for (int j = 0; j <= order; ++j)
    for (int i = 0; i < width; ++i) {
      const int column = std::min(i / order, columns - 1);
      const double s = (points[i - column * order] + 1) / 2;
      mesh.nodes.push_back({ends[column] + s * (ends[column + 1] - ends[column]), height * (points[j] + 1) / 2});
    }
  for (int column = 0; column < columns; ++column) {
    for (int j = 0; j <= order; ++j)
      for (int i = 0; i <= order; ++i) mesh.elem_nodes.push_back(j * width + column * order + i);
    mesh.elem_block.push_back(0);
  }
  mesh.elem_scaled_jacobian.assign(columns, 1);
  mesh.elem_jacobian_bound.assign(columns, 1);
  measure_element_sizes(mesh);
  return mesh;
}

}  // namespace quadrille::mesh
