#include "layers/shift_along_rows.hpp"

#include "spectral/quadrature.hpp"

namespace quadrille::layers {
namespace {

/// The vertices of a row of nodes.
std::vector<Vec2> row_vertices(const std::vector<Vec2>& nodes, int width, int order, int row) {
  std::vector<Vec2> vertices;
  for (int i = 0; i < width; i += order) vertices.push_back(nodes[row * width + i]);
  return vertices;
}

/// Where the vertices of a row of nodes come to lie, in its intervals.
std::vector<double> shifted_vertices(const RowShifts& shifts, double row) {
  std::vector<double> at, along;
  for (std::size_t column = 0; column < shifts.front().size(); ++column) {
    along.clear();
    for (const std::vector<double>& of_row : shifts) along.push_back(of_row[column]);
    at.push_back(static_cast<double>(column) + index_cubic(along, row).value);
  }
  return at;
}

}  // namespace

std::vector<Vec2> shifted_along_rows(const std::vector<Vec2>& nodes, int width, int order, const RowShifts& shifts) {
  const std::vector<double>& points = spectral::gll_points(order);
  const auto fraction = [&](int node) { return (1 + points[node % order]) / 2; };  // in its element
  const auto intervals = [&](int node) {
    const int element = node / order;
    return element + fraction(node);
  };
  const int height = static_cast<int>(nodes.size()) / width;
  std::vector<Vec2> result = nodes;
  for (int j = 1; j + 1 < height; ++j) {
    const std::vector<Vec2> vertices = row_vertices(nodes, width, order, j);
    const std::vector<double> at = shifted_vertices(shifts, intervals(j));
    for (int i = 1; i + 1 < width; ++i) {
      const int k = i / order;
      const double part = fraction(i);
      const double now = part > 0 ? at[k] + part * (at[k + 1] - at[k]) : at[k];
      result[j * width + i] += index_cubic(vertices, now).value - index_cubic(vertices, k + part).value;
    }
  }
  return result;
}

}  // namespace quadrille::layers
