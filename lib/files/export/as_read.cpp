#include "export/as_read.hpp"

#include <cstddef>
#include <vector>

#include "export/cells.hpp"
#include "export/split_elements.hpp"
#include "export/split_hexes.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::exports {

namespace {

/// The blend at one node of an element: the sum over all sets of the coordinates in which it lies inside, of
/// (-1)^(size + 1) times the linear interpolant along these coordinates.
template <typename Point>
Point blend_at(const std::vector<double>& points, const std::vector<int>& strides, int local,
               const std::vector<Point>& nodes) {
  const int width = static_cast<int>(points.size());
  std::vector<int> inner;  // strides of these coordinates
  for (const int stride : strides)
    if (const int at = local / stride % width; at > 0 && at < width - 1) inner.push_back(stride);
  Point sum;
  // A coordinate stays (0), or the node moves to its lower (1) or upper end (2).
  int choices = 1;
  for (std::size_t c = 0; c < inner.size(); ++c) choices *= 3;
  for (int choice = 1; choice < choices; ++choice) {
    int node = local, rest = choice;
    double weight = -1;
    for (const int stride : inner) {
      const int at = local / stride % width, end = rest % 3;
      rest /= 3;
      if (end == 0) continue;
      const double s = (1 + points[at]) / 2;
      weight *= end == 1 ? -(1 - s) : -s;
      node += ((end == 1 ? 0 : width - 1) - at) * stride;
    }
    sum += weight * nodes[node];
  }
  return sum;
}

/// Replaces the nodes that lie inside in more than `known` coordinates, those on faces first.
template <typename Point>
void blend_inside(int order, int dimension, int known, const std::vector<int>& elem_nodes, std::vector<Point>& nodes) {
  const std::vector<double>& points = spectral::gll_points(order);
  const int width = order + 1;
  std::vector<int> strides{1};
  for (int c = 1; c < dimension; ++c) strides.push_back(strides.back() * width);
  const int count = strides.back() * width;
  std::vector<Point> own(count);
  for (std::size_t first = 0; first < elem_nodes.size(); first += count) {
    for (int k = 0; k < count; ++k) own[k] = nodes[elem_nodes[first + k]];
    for (int level = known + 1; level <= dimension; ++level)
      for (int k = 0; k < count; ++k)
        if (inner_coordinates(order, dimension, k) == level) own[k] = blend_at(points, strides, k, own);
    for (int k = 0; k < count; ++k) nodes[elem_nodes[first + k]] = own[k];
  }
}

int known_coordinates(const ExportFormat& format, int dimension) {
  if (format.written_nodes == WrittenNodes::all) return dimension;
  return format.written_nodes == WrittenNodes::sides ? dimension - 1 : 1;
}

}  // namespace

QuadMesh as_read(const QuadMesh& mesh, const ExportFormat& format) {
  QuadMesh read = format.pieces == WrittenPieces::whole           ? mesh
                  : format.pieces == WrittenPieces::between_nodes ? split_at_nodes(mesh)
                                                                  : split_to_quadratic(mesh);
  const int known = known_coordinates(format, 2);
  if (read.order == 1 || known == 2) return read;
  blend_inside(read.order, 2, known, read.elem_nodes, read.nodes);
  if (!read.space_nodes.empty()) blend_inside(read.order, 2, known, read.elem_nodes, read.space_nodes);
  return read;
}

HexMesh as_read(const HexMesh& mesh, const ExportFormat& format) {
  HexMesh read = format.pieces == WrittenPieces::between_nodes ? split_at_nodes(mesh) : mesh;
  const int known = known_coordinates(format, 3);
  if (read.order > 1 && known < 3) blend_inside(read.order, 3, known, read.elem_nodes, read.nodes);
  return read;
}

int source_element(const QuadMesh& mesh, const QuadMesh& read, int elem) {
  return elem / (read.num_elems() / mesh.num_elems());
}

int source_element(const HexMesh& mesh, const HexMesh& read, int elem) {
  const int layer = elem / read.num_quads / (read.num_layers() / mesh.num_layers());
  return layer * mesh.num_quads + elem % read.num_quads / (read.num_quads / mesh.num_quads);
}

}  // namespace quadrille::exports
