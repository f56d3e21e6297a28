#include "export/renode.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "model/quad_mesh.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/quad_map.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::exports {

namespace {

void move_edge(const QuadMesh& mesh, const Eigen::MatrixXd& from_gll, const std::vector<int>& edge,
               std::vector<Vec2>& moved) {
  for (int i = 1; i < mesh.order; ++i) {
    Vec2 sum;
    for (int k = 0; k <= mesh.order; ++k) sum += from_gll(i, k) * mesh.nodes[edge[k]];
    moved[edge[i]] = sum;
  }
}

void move_inside(const QuadMesh& mesh, const Eigen::MatrixXd& from_gll, const int* ids, std::vector<Vec2>& moved) {
  const int n = mesh.order, width = n + 1;
  std::vector<Vec2> half(width * width);
  for (int b = 0; b <= n; ++b)
    for (int i = 1; i < n; ++i)
      for (int a = 0; a <= n; ++a) half[b * width + i] += from_gll(i, a) * mesh.nodes[ids[b * width + a]];
  for (int j = 1; j < n; ++j)
    for (int i = 1; i < n; ++i) {
      Vec2 sum;
      for (int b = 0; b <= n; ++b) sum += from_gll(j, b) * half[b * width + i];
      moved[ids[j * width + i]] = sum;
    }
}

/// Row i: the Bernstein polynomials of degree N at Gauss-Lobatto-Legendre point i.
Eigen::MatrixXd bernstein_at_gll(int order) {
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(order + 1, order + 1);
  for (int i = 0; i <= order; ++i) {
    const double t = (1 + spectral::gll_points(order)[i]) / 2;
    values(i, 0) = 1;
    for (int degree = 1; degree <= order; ++degree)  // de Casteljau's triangle
      for (int k = degree; k >= 0; --k) values(i, k) = (1 - t) * values(i, k) + (k > 0 ? t * values(i, k - 1) : 0.0);
  }
  return values;
}

}  // namespace

std::vector<Vec2> renoded(const QuadMesh& mesh, const Eigen::MatrixXd& from_gll) {
  std::vector<Vec2> moved = mesh.nodes;
  if (mesh.order == 1) return moved;
  std::vector<bool> done(mesh.nodes.size(), false);  // by the first inner node of an edge
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    for (int side = 0; side < 4; ++side) {
      const std::vector<int> edge = side_nodes(mesh, elem, side);
      if (done[edge[1]] || done[edge[mesh.order - 1]]) continue;
      done[edge[1]] = true;
      move_edge(mesh, from_gll, edge, moved);
    }
    move_inside(mesh, from_gll, &mesh.elem_nodes[elem * mesh.nodes_per_elem()], moved);
  }
  return moved;
}

std::vector<Vec2> bezier_points(const QuadMesh& mesh) { return renoded(mesh, bernstein_at_gll(mesh.order).inverse()); }

std::vector<Vec2> equispaced_nodes(const QuadMesh& mesh) {
  if (mesh.order <= 2) return mesh.nodes;  // the same points
  std::vector<double> points;
  for (int i = 0; i <= mesh.order; ++i) points.push_back(-1 + 2.0 * i / mesh.order);
  return renoded(mesh, spectral::interpolation_matrix(spectral::gll_points(mesh.order), points));
}

std::vector<double> chebyshev_lobatto_points(int order) {
  std::vector<double> points;
  for (int j = 0; j <= order; ++j) points.push_back(std::sin(std::numbers::pi * (2 * j - order) / (2 * order)));
  return points;
}

namespace {

/// The element rebuilt by the reader: nodes as in model/quad_mesh.hpp, from the sides of `nodes` alone.
std::vector<Vec2> transfinite_element(int order, const Vec2* nodes) {
  const int n = order, width = n + 1;
  const std::vector<double>& points = spectral::gll_points(n);
  const auto at = [&](int i, int j) { return nodes[j * width + i]; };
  std::vector<Vec2> rebuilt(nodes, nodes + width * width);
  for (int j = 1; j < n; ++j)
    for (int i = 1; i < n; ++i) {
      const double s = (1 + points[i]) / 2, t = (1 + points[j]) / 2;
      rebuilt[j * width + i] =
          (1 - s) * at(0, j) + s * at(n, j) + (1 - t) * at(i, 0) + t * at(i, n) -
          ((1 - t) * ((1 - s) * at(0, 0) + s * at(n, 0)) + t * ((1 - s) * at(0, n) + s * at(n, n)));
    }
  return rebuilt;
}

/// The same if the reader knows only the ends and the middle of each side: an element of order 2.
std::vector<Vec2> quadratic_element(int order, const Vec2* nodes) {
  const int n = order, width = n + 1;
  const auto corner = [&](int i, int j) { return nodes[j * n * width + i * n]; };
  std::vector<Vec2> nine(9);
  for (const int j : {0, 1})
    for (const int i : {0, 1}) nine[6 * j + 2 * i] = corner(i, j);
  const Eigen::MatrixXd middle = spectral::interpolation_matrix(spectral::gll_points(n), {0.0});
  for (int k = 0; k <= n; ++k) {
    nine[1] += middle(0, k) * nodes[k];
    nine[7] += middle(0, k) * nodes[n * width + k];
    nine[3] += middle(0, k) * nodes[k * width];
    nine[5] += middle(0, k) * nodes[k * width + n];
  }
  return transfinite_element(2, nine.data());
}

/// `nodes` as an element of order 2 at the points of the given order.
std::vector<Vec2> raised(const std::vector<Vec2>& quadratic, const Eigen::MatrixXd& basis) {
  const auto width = basis.rows();
  std::vector<Vec2> points(static_cast<std::size_t>(width * width));
  for (Eigen::Index j = 0; j < width; ++j)
    for (Eigen::Index i = 0; i < width; ++i)
      for (int b = 0; b < 3; ++b)
        for (int a = 0; a < 3; ++a) points[j * width + i] += basis(i, a) * basis(j, b) * quadratic[b * 3 + a];
  return points;
}

class Meter {
 public:
  Meter(const QuadMesh& mesh, RebuiltFrom from, const std::string& reader)
      : mesh_(mesh),
        from_(from),
        reader_(reader),
        to_order_(spectral::interpolation_matrix(spectral::gll_points(2), spectral::gll_points(mesh.order))) {}

  TransfiniteLoss measure() {
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) add(elem);
    return loss_;
  }

 private:
  void add(int elem) {
    const int count = mesh_.nodes_per_elem();
    ours_.resize(count);
    for (int k = 0; k < count; ++k) ours_[k] = mesh_.nodes[mesh_.elem_nodes[elem * count + k]];
    const bool is_quadratic = from_ == RebuiltFrom::quadratic_sides;
    const std::vector<Vec2> rebuilt =
        is_quadratic ? quadratic_element(mesh_.order, ours_.data()) : transfinite_element(mesh_.order, ours_.data());
    const double moved = compare(is_quadratic ? raised(rebuilt, to_order_) : rebuilt);
    // An element that moves by no more than rounding is proved valid by the mesh already.
    if (moved > 1e-14 * mesh_.face.diameter) require_valid(elem, is_quadratic ? 2 : mesh_.order, rebuilt);
  }

  /// The largest distance of this element, which also enters loss_.
  double compare(const std::vector<Vec2>& theirs) {
    const int n = mesh_.order;
    double largest = 0;
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) {
        const double d = distance(ours_[j * (n + 1) + i], theirs[j * (n + 1) + i]);
        largest = std::max(largest, d);
        if (i == 0 || i == n || j == 0 || j == n) loss_.sides = std::max(loss_.sides, d);
      }
    loss_.interior = std::max(loss_.interior, largest);
    return largest;
  }

  void require_valid(int elem, int order, const std::vector<Vec2>& rebuilt) const {
    if (spectral::quad_jacobian_lower_bound(order, rebuilt.data()) > 0) return;
    const Vec2 middle = spectral::quad_position(mesh_.order, ours_.data(), {0, 0}) + mesh_.face.origin;
    throw ComputeError(
        fmt::format("{} rebuilds elements from their sides, and element {} near {} would be folded; refine the mesh",
                    reader_, elem, position_text(middle)));
  }

  const QuadMesh& mesh_;
  RebuiltFrom from_;
  const std::string& reader_;
  Eigen::MatrixXd to_order_;
  std::vector<Vec2> ours_;
  TransfiniteLoss loss_;
};

}  // namespace

TransfiniteLoss transfinite_loss(const QuadMesh& mesh, RebuiltFrom from, const std::string& reader) {
  return Meter(mesh, from, reader).measure();
}

std::string length_text(double length, double diameter) {
  return fmt::format("{:.2g} ({:.2g} of the diameter)", length, length / diameter);
}

double distance_from_side_blend(const QuadMesh& mesh, int elem) {
  const int count = mesh.nodes_per_elem();
  std::vector<Vec2> ours;
  for (int k = 0; k < count; ++k) ours.push_back(mesh.nodes[mesh.elem_nodes[elem * count + k]]);
  const std::vector<Vec2> blend = transfinite_element(mesh.order, ours.data());
  double largest = 0;
  for (int k = 0; k < count; ++k) largest = std::max(largest, distance(blend[k], ours[k]));
  return largest;
}

bool is_straight_edge(const QuadMesh& mesh, const std::vector<int>& edge_nodes) {
  const std::vector<double>& points = spectral::gll_points(mesh.order);
  const Vec2 start = mesh.nodes[edge_nodes.front()], end = mesh.nodes[edge_nodes.back()];
  const double tol = 1e-10 * distance(start, end) + 1e-14 * mesh.face.diameter;
  for (int k = 1; k < mesh.order; ++k) {
    const double s = (1 + points[k]) / 2;
    if (distance((1 - s) * start + s * end, mesh.nodes[edge_nodes[k]]) > tol) return false;
  }
  return true;
}

}  // namespace quadrille::exports
