#include "export/hex_blend.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "export/cells.hpp"
#include "spectral/lagrange.hpp"
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

/// Elements rebuilt from their corners and the middles of their edges.
class QuadraticEdges {
 public:
  explicit QuadraticEdges(const HexMesh& mesh)
      : mesh_(mesh),
        points_(spectral::gll_points(mesh.order)),
        slopes_(spectral::differentiation_matrix(points_)),
        rebuilt_(mesh.nodes_per_elem()) {}

  const std::vector<Vec3>& rebuild(int elem) {
    std::array<Vec3, 12> bulges;  // of the middles from the straight edges
    for (int e = 0; e < 12; ++e) {
      const std::vector<int> nodes = edge_nodes(mesh_, elem, e);
      bulges[e] = edge_middle(mesh_, nodes) - 0.5 * (mesh_.nodes[nodes.front()] + mesh_.nodes[nodes.back()]);
    }
    const std::size_t first = static_cast<std::size_t>(elem) * mesh_.nodes_per_elem();
    for (int local = 0; local < mesh_.nodes_per_elem(); ++local) {
      const std::array<double, 3> s = parameters(local);
      Vec3 x;
      for (int c = 0; c < 8; ++c)
        x += weight(c, s, -1) * mesh_.nodes[mesh_.elem_nodes[first + hex_corner_node(mesh_.order, c)]];
      for (int e = 0; e < 12; ++e) {
        const int axis = e >= 8 ? 2 : e % 2;
        x += 4 * s[axis] * (1 - s[axis]) * weight(hex_edge_corners[e][0], s, axis) * bulges[e];
      }
      rebuilt_[local] = x;
    }
    return rebuilt_;
  }

  /// Of the element that was rebuilt last.
  double least_det() const {
    double least = 1e300;
    const int n = mesh_.order, width = n + 1;
    const std::array<int, 3> strides{1, width, width * width};
    for (int local = 0; local < mesh_.nodes_per_elem(); ++local) {
      std::array<Vec3, 3> columns;
      for (int axis = 0; axis < 3; ++axis) {
        const int at = local / strides[axis] % width, start = local - at * strides[axis];
        for (int k = 0; k <= n; ++k) columns[axis] += slopes_(at, k) * rebuilt_[start + k * strides[axis]];
      }
      least = std::min(least, dot(columns[0], cross(columns[1], columns[2])));
    }
    return least;
  }

 private:
  std::array<double, 3> parameters(int local) const {
    const int width = mesh_.order + 1;
    const auto s = [&](int at) { return (1 + points_[at]) / 2; };
    return {s(local % width), s(local / width % width), s(local / (width * width))};
  }

  /// The linear function that is 1 at a corner and 0 at the others, constant along an axis if that is not -1.
  static double weight(int corner, const std::array<double, 3>& s, int constant_axis) {
    double product = 1;
    for (int axis = 0; axis < 3; ++axis)
      if (axis != constant_axis) product *= hex_corner_indices[corner][axis] == 0 ? 1 - s[axis] : s[axis];
    return product;
  }

  const HexMesh& mesh_;
  const std::vector<double>& points_;
  Eigen::MatrixXd slopes_;
  std::vector<Vec3> rebuilt_;
};

}  // namespace

Vec3 edge_middle(const HexMesh& mesh, const std::vector<int>& nodes) {
  const Eigen::MatrixXd to_middle = spectral::interpolation_matrix(spectral::gll_points(mesh.order), {0.0});
  Vec3 middle;
  for (int k = 0; k <= mesh.order; ++k) middle += to_middle(0, k) * mesh.nodes[nodes[k]];
  return middle;
}

QuadraticEdgeLoss quadratic_edge_loss(const HexMesh& mesh, const char* reader) {
  QuadraticEdgeLoss loss;
  QuadraticEdges edges(mesh);
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const std::vector<Vec3>& rebuilt = edges.rebuild(elem);
    const int* nodes = element_nodes(mesh, elem);
    for (int local = 0; local < mesh.nodes_per_elem(); ++local) {
      double& largest = inner_coordinates(mesh.order, 3, local) <= 1 ? loss.edges : loss.others;
      largest = std::max(largest, distance(rebuilt[local], mesh.nodes[nodes[local]]));
    }
    if (!(edges.least_det() > 0))
      throw ComputeError(
          fmt::format("the hexahedron at {} is folded if it is rebuilt from quadratic edges, as {} does: "
                      "refine the mesh",
                      position_text(mesh.nodes[nodes[0]]), reader));
  }
  return loss;
}

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
