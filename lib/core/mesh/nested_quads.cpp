#include "mesh/nested_quads.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "spectral/lagrange.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::mesh {
namespace {

/// Interpolates from the N + 1 nodes of an interval to the m N + 1 nodes of its m equal parts.
Eigen::MatrixXd part_nodes(int order, int parts) {
  const std::vector<double>& points = spectral::gll_points(order);
  std::vector<double> fine{-1};
  for (int k = 0; k < parts; ++k) {
    for (int i = 1; i < order; ++i) fine.push_back(-1 + (2 * k + 1 + points[i]) / parts);
    fine.push_back(-1 + 2.0 * (k + 1) / parts);
  }
  return spectral::interpolation_matrix(points, fine);
}

class Refiner {
 public:
  Refiner(const QuadMesh& coarse, int parts)
      : coarse_(coarse),
        parts_(parts),
        width_(parts * coarse.order + 1),
        interpolate_(part_nodes(coarse.order, parts)),
        refined_(without_elements()) {}

  QuadMesh refine() {
    keep_vertices();
    for (int e = 0; e < coarse_.num_elems(); ++e) append_children(e, grid_of(e));
    refined_.boundary_edges = children_of(coarse_.boundary_edges);
    refined_.interface_edges = children_of(coarse_.interface_edges);
    return std::move(refined_);
  }

 private:
  QuadMesh without_elements() const {
    QuadMesh mesh = coarse_;
    mesh.nodes.clear();
    for (auto* list : {&mesh.elem_nodes, &mesh.elem_block}) list->clear();
    for (auto* list : {&mesh.elem_jacobian_bound, &mesh.elem_scaled_jacobian, &mesh.elem_edge_ratio,
                       &mesh.elem_area_jump, &mesh.elem_node_distance, &mesh.elem_prescribed_length})
      list->clear();
    return mesh;
  }

  void keep_vertices() {
    vertex_.assign(coarse_.nodes.size(), -1);
    for (int e = 0; e < coarse_.num_elems(); ++e)
      for (int side = 0; side < 4; ++side) vertex_[side_start(coarse_, e, side)] = 0;
    for (std::size_t n = 0; n < vertex_.size(); ++n)
      if (vertex_[n] == 0) vertex_[n] = append_node(coarse_.nodes[n]);
  }

  int append_node(Vec2 position) {
    refined_.nodes.push_back(position);
    return static_cast<int>(refined_.nodes.size()) - 1;
  }

  /// The refined nodes of a side from corner to corner. They are made once for both elements, from the end of the lower
  /// number; two sides between the same corners differ in their nodes.
  std::vector<int> refined_side_nodes(int elem, int side) {
    std::vector<int> nodes = side_nodes(coarse_, elem, side);
    const bool is_turned = nodes.front() > nodes.back();
    if (is_turned) std::reverse(nodes.begin(), nodes.end());
    auto [known, is_new] = sides_.try_emplace(nodes);
    if (is_new) known->second = refined_side(nodes);
    std::vector<int> refined = known->second;
    if (is_turned) std::reverse(refined.begin(), refined.end());
    return refined;
  }

  std::vector<int> refined_side(const std::vector<int>& nodes) {
    std::vector<int> refined{vertex_[nodes.front()]};
    for (int k = 1; k + 1 < width_; ++k) {
      Vec2 position;
      for (std::size_t i = 0; i < nodes.size(); ++i)
        position += interpolate_(k, static_cast<Eigen::Index>(i)) * coarse_.nodes[nodes[i]];
      refined.push_back(append_node(position));
    }
    refined.push_back(vertex_[nodes.back()]);
    return refined;
  }

  /// The refined nodes of an element, width_ x width_, along xi1 fastest.
  std::vector<int> grid_of(int elem) {
    std::vector<int> grid(static_cast<std::size_t>(width_) * width_);
    for (int side = 0; side < 4; ++side) {
      const std::vector<int> nodes = refined_side_nodes(elem, side);
      for (int k = 0; k < width_; ++k) grid[local_side_node(width_ - 1, side, k)] = nodes[k];
    }
    const int n = coarse_.order + 1;
    Eigen::MatrixXd x(n, n), y(n, n);
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const Vec2 position = coarse_.nodes[coarse_.elem_nodes[elem * n * n + j * n + i]];
        x(i, j) = position.x, y(i, j) = position.y;
      }
    const Eigen::MatrixXd fine_x = interpolate_ * x * interpolate_.transpose();
    const Eigen::MatrixXd fine_y = interpolate_ * y * interpolate_.transpose();
    for (int j = 1; j + 1 < width_; ++j)
      for (int i = 1; i + 1 < width_; ++i) grid[j * width_ + i] = append_node({fine_x(i, j), fine_y(i, j)});
    return grid;
  }

  void append_children(int elem, const std::vector<int>& grid) {
    const int order = coarse_.order;
    for (int row = 0; row < parts_; ++row)
      for (int column = 0; column < parts_; ++column) {
        refined_.elem_block.push_back(coarse_.elem_block[elem]);
        if (!coarse_.elem_prescribed_length.empty())
          refined_.elem_prescribed_length.push_back(coarse_.elem_prescribed_length[elem] / parts_);
        if (!coarse_.elem_prescribed_stretch.empty())
          refined_.elem_prescribed_stretch.push_back(coarse_.elem_prescribed_stretch[elem]);
        for (int j = 0; j <= order; ++j)
          for (int i = 0; i <= order; ++i)
            refined_.elem_nodes.push_back(grid[(row * order + j) * width_ + column * order + i]);
      }
  }

  std::vector<QuadBoundaryEdge> children_of(const std::vector<QuadBoundaryEdge>& edges) const {
    std::vector<QuadBoundaryEdge> children;
    for (const QuadBoundaryEdge& edge : edges)
      for (int k = 0; k < parts_; ++k)
        children.push_back(
            {edge.elem * parts_ * parts_ + local_side_node(parts_ - 1, edge.side, k), edge.side, edge.curve});
    return children;
  }

  const QuadMesh& coarse_;
  int parts_, width_;
  Eigen::MatrixXd interpolate_;
  QuadMesh refined_;
  std::vector<int> vertex_;  ///< refined number of each coarse vertex, -1 for other nodes
  std::map<std::vector<int>, std::vector<int>> sides_;
};

}  // namespace

QuadMesh nested_quads(const QuadMesh& mesh, int levels) {
  return levels == 0 ? mesh : Refiner(mesh, 1 << levels).refine();
}

}  // namespace quadrille::mesh
