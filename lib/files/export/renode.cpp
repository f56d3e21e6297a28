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

template <typename Point>
void move_edge(const std::vector<Point>& nodes, const Eigen::MatrixXd& from_gll, const std::vector<int>& edge,
               std::vector<Point>& moved) {
  const int order = static_cast<int>(edge.size()) - 1;
  for (int i = 1; i < order; ++i) {
    Point sum;
    for (int k = 0; k <= order; ++k) sum += from_gll(i, k) * nodes[edge[k]];
    moved[edge[i]] = sum;
  }
}

template <typename Point>
void move_inside(int n, const std::vector<Point>& nodes, const Eigen::MatrixXd& from_gll, const int* ids,
                 std::vector<Point>& moved) {
  const int width = n + 1;
  std::vector<Point> half(width * width);
  for (int b = 0; b <= n; ++b)
    for (int i = 1; i < n; ++i)
      for (int a = 0; a <= n; ++a) half[b * width + i] += from_gll(i, a) * nodes[ids[b * width + a]];
  for (int j = 1; j < n; ++j)
    for (int i = 1; i < n; ++i) {
      Point sum;
      for (int b = 0; b <= n; ++b) sum += from_gll(j, b) * half[b * width + i];
      moved[ids[j * width + i]] = sum;
    }
}

template <typename Point>
std::vector<Point> renoded_points(const QuadMesh& mesh, const std::vector<Point>& nodes,
                                  const Eigen::MatrixXd& from_gll) {
  std::vector<Point> moved = nodes;
  if (mesh.order == 1) return moved;
  std::vector<bool> done(nodes.size(), false);  // by the first inner node of an edge
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    for (int side = 0; side < 4; ++side) {
      const std::vector<int> edge = side_nodes(mesh, elem, side);
      if (done[edge[1]] || done[edge[mesh.order - 1]]) continue;
      done[edge[1]] = true;
      move_edge(nodes, from_gll, edge, moved);
    }
    move_inside(mesh.order, nodes, from_gll, &mesh.elem_nodes[elem * mesh.nodes_per_elem()], moved);
  }
  return moved;
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
  return renoded_points(mesh, mesh.nodes, from_gll);
}

namespace {

Eigen::MatrixXd bezier_from_gll(int order) { return bernstein_at_gll(order).inverse(); }

Eigen::MatrixXd equispaced_from_gll(int order) {
  std::vector<double> points;
  for (int i = 0; i <= order; ++i) points.push_back(-1 + 2.0 * i / order);
  return spectral::interpolation_matrix(spectral::gll_points(order), points);
}

Eigen::MatrixXd from_gll(int order, ElementPoints points) {
  return points == ElementPoints::bezier ? bezier_from_gll(order) : equispaced_from_gll(order);
}

/// Nodes of order 2 and below are equispaced.
bool are_nodes(int order, ElementPoints points) {
  return points == ElementPoints::nodes || (points == ElementPoints::equispaced && order <= 2);
}

template <typename Point>
std::vector<Point> points_of(const QuadMesh& mesh, const std::vector<Point>& nodes, ElementPoints points) {
  return are_nodes(mesh.order, points) ? nodes : renoded_points(mesh, nodes, from_gll(mesh.order, points));
}

/// The values of a tensor of width^3 points after a change of nodes along the axis with this stride.
void change_along(const Eigen::MatrixXd& from_gll, int stride, std::vector<Vec3>& values) {
  const int width = static_cast<int>(from_gll.rows()), count = static_cast<int>(values.size());
  std::vector<Vec3> line(width);
  for (int first = 0; first < count; ++first) {
    if (first / stride % width != 0) continue;
    for (int k = 0; k < width; ++k) line[k] = values[first + k * stride];
    for (int i = 0; i < width; ++i) {
      Vec3 sum;
      for (int k = 0; k < width; ++k) sum += from_gll(i, k) * line[k];
      values[first + i * stride] = sum;
    }
  }
}

std::array<double, 3> coordinates(Vec3 x) { return {x.x, x.y, x.z}; }

}  // namespace

std::vector<std::array<double, 3>> positions(const QuadMesh& mesh, const Frame& frame, ElementPoints points) {
  std::vector<std::array<double, 3>> result;
  result.reserve(mesh.nodes.size());
  if (mesh.space_nodes.empty())
    for (const Vec2 x : points_of(mesh, mesh.nodes, points)) result.push_back(frame.at(x));
  else
    for (const Vec3 x : points_of(mesh, mesh.space_nodes, points)) result.push_back(coordinates(x));
  return result;
}

// The rows of both ends are those of the unit matrix, so that a node of a face, or of an edge, depends on the nodes of
// that alone.
std::vector<Vec3> renoded(const HexMesh& mesh, const Eigen::MatrixXd& from_gll) {
  const int count = mesh.nodes_per_elem(), width = mesh.order + 1;
  std::vector<Vec3> moved(mesh.nodes.size()), values(count);
  std::vector<bool> is_known(mesh.nodes.size(), false);
  for (std::size_t first = 0; first < mesh.elem_nodes.size(); first += count) {
    for (int k = 0; k < count; ++k) values[k] = mesh.nodes[mesh.elem_nodes[first + k]];
    for (const int stride : {1, width, width * width}) change_along(from_gll, stride, values);
    for (int k = 0; k < count; ++k) {
      const int node = mesh.elem_nodes[first + k];
      if (!is_known[node]) moved[node] = values[k];
      is_known[node] = true;
    }
  }
  return moved;
}

std::vector<std::array<double, 3>> positions(const HexMesh& mesh, ElementPoints points) {
  std::vector<std::array<double, 3>> result;
  result.reserve(mesh.nodes.size());
  const bool as_they_are = are_nodes(mesh.order, points);
  for (const Vec3 x : as_they_are ? mesh.nodes : renoded(mesh, from_gll(mesh.order, points)))
    result.push_back(coordinates(x));
  return result;
}

std::array<double, 3> position(const QuadMesh& mesh, const Frame& frame, int node) {
  return mesh.space_nodes.empty() ? frame.at(mesh.nodes[node]) : coordinates(mesh.space_nodes[node]);
}

int space_dimension(const QuadMesh& mesh, const Frame& frame) {
  return mesh.space_nodes.empty() && frame.is_plane() ? 2 : 3;
}

std::vector<double> chebyshev_lobatto_points(int order) {
  std::vector<double> points;
  for (int j = 0; j <= order; ++j) points.push_back(std::sin(std::numbers::pi * (2 * j - order) / (2 * order)));
  return points;
}

namespace {

/// The element rebuilt by the reader: nodes as in model/quad_mesh.hpp, from the sides of `nodes` alone.
template <typename Point>
std::vector<Point> transfinite_element(int order, const Point* nodes) {
  const int n = order, width = n + 1;
  const std::vector<double>& points = spectral::gll_points(n);
  const auto at = [&](int i, int j) { return nodes[j * width + i]; };
  std::vector<Point> rebuilt(nodes, nodes + width * width);
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

namespace {

template <typename Point>
double distance_from_blend(const QuadMesh& mesh, const std::vector<Point>& nodes, int elem) {
  const int count = mesh.nodes_per_elem();
  std::vector<Point> ours;
  for (int k = 0; k < count; ++k) ours.push_back(nodes[mesh.elem_nodes[elem * count + k]]);
  const std::vector<Point> blend = transfinite_element(mesh.order, ours.data());
  double largest = 0;
  for (int k = 0; k < count; ++k) largest = std::max(largest, distance(blend[k], ours[k]));
  return largest;
}

template <typename Point>
bool is_straight(const QuadMesh& mesh, const std::vector<Point>& nodes, const std::vector<int>& edge_nodes) {
  const std::vector<double>& points = spectral::gll_points(mesh.order);
  const Point start = nodes[edge_nodes.front()], end = nodes[edge_nodes.back()];
  const double tol = 1e-10 * distance(start, end) + 1e-14 * mesh.face.diameter;
  for (int k = 1; k < mesh.order; ++k) {
    const double s = (1 + points[k]) / 2;
    if (distance((1 - s) * start + s * end, nodes[edge_nodes[k]]) > tol) return false;
  }
  return true;
}

}  // namespace

double distance_from_side_blend(const QuadMesh& mesh, int elem) {
  return mesh.space_nodes.empty() ? distance_from_blend(mesh, mesh.nodes, elem)
                                  : distance_from_blend(mesh, mesh.space_nodes, elem);
}

bool is_straight_edge(const QuadMesh& mesh, const std::vector<int>& edge_nodes) {
  return mesh.space_nodes.empty() ? is_straight(mesh, mesh.nodes, edge_nodes)
                                  : is_straight(mesh, mesh.space_nodes, edge_nodes);
}

}  // namespace quadrille::exports
