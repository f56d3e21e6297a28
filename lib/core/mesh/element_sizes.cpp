#include "mesh/element_sizes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/message_text.hpp"
#include "model/quad_mesh.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/per_order.hpp"
#include "spectral/quadrature.hpp"
#include "surface/positions.hpp"

namespace quadrille::mesh {

namespace {

constexpr double greatest_ratio = 1e300;

struct LobattoRule {
  std::vector<double> weights;
  Eigen::MatrixXd derivative;

  explicit LobattoRule(int order)
      : weights(spectral::gauss_lobatto(order + 1).weights),
        derivative(spectral::differentiation_matrix(spectral::gll_points(order))) {}
};

double ratio_of(double a, double b) {
  const auto [low, high] = std::minmax(a, b);
  return low > high / greatest_ratio ? high / low : greatest_ratio;
}

/// Of the parallelogram; in the plane with its sign.
double area_of(Vec2 a, Vec2 b) { return cross(a, b); }
double area_of(Vec3 a, Vec3 b) { return norm(cross(a, b)); }

/// The nodes of an element as a grid of (N + 1) x (N + 1) positions.
template <typename Point>
class ElementGrid {
 public:
  ElementGrid(const QuadMesh& mesh, const std::vector<Point>& nodes, int elem)
      : order_(mesh.order),
        rule_(spectral::table_per_order<LobattoRule>(mesh.order)),
        nodes_(nodes),
        ids_(&mesh.elem_nodes[elem * mesh.nodes_per_elem()]) {}

  Point at(int i, int j) const { return nodes_[ids_[j * (order_ + 1) + i]]; }

  double side_length(int side) const {
    double length = 0;
    for (int k = 0; k <= order_; ++k)
      length += rule_.weights[k] *
                norm(side % 2 == 0 ? along(0, k, side == 0 ? 0 : order_) : along(1, side == 3 ? 0 : order_, k));
    return length;
  }

  double area() const {
    double area = 0;
    for (int j = 0; j <= order_; ++j)
      for (int i = 0; i <= order_; ++i)
        area += rule_.weights[i] * rule_.weights[j] * area_of(along(0, i, j), along(1, i, j));
    return area;
  }

  /// Between neighbours in the grid, also diagonal ones.
  double least_node_distance() const {
    double least = distance(at(0, 0), at(1, 0));
    for (int j = 0; j <= order_; ++j)
      for (int i = 0; i <= order_; ++i) {
        if (i < order_) least = std::min(least, distance(at(i, j), at(i + 1, j)));
        if (j == order_) continue;
        for (int k = std::max(i - 1, 0); k <= std::min(i + 1, order_); ++k)
          least = std::min(least, distance(at(i, j), at(k, j + 1)));
      }
    return least;
  }

 private:
  /// The derivative with respect to xi1 (direction 0) or xi2 (1) at node (i, j).
  Point along(int direction, int i, int j) const {
    Point sum;
    for (int k = 0; k <= order_; ++k)
      sum += direction == 0 ? rule_.derivative(i, k) * at(k, j) : rule_.derivative(j, k) * at(i, k);
    return sum;
  }

  int order_;
  const LobattoRule& rule_;
  const std::vector<Point>& nodes_;
  const int* ids_;
};

template <typename Point>
double edge_ratio(const ElementGrid<Point>& grid) {
  std::array<double, 4> lengths{};
  for (int side = 0; side < 4; ++side) lengths[side] = grid.side_length(side);
  const auto [low, high] = std::minmax_element(lengths.begin(), lengths.end());
  return ratio_of(*low, *high);
}

/// A side by its ends and the node next to the lower one, and its element.
struct Side {
  int low, high, inner, elem;
  auto operator<=>(const Side&) const = default;
  bool is_same_place(const Side& other) const { return low == other.low && high == other.high && inner == other.inner; }
};

std::vector<Side> sorted_sides(const QuadMesh& mesh) {
  const int n = mesh.order;
  std::vector<Side> sides;
  for (int elem = 0; elem < mesh.num_elems(); ++elem)
    for (int k = 0; k < 4; ++k) {
      const int from = side_node(mesh, elem, k, 0), to = side_node(mesh, elem, k, n);
      sides.push_back({std::min(from, to), std::max(from, to), side_node(mesh, elem, k, from < to ? 1 : n - 1), elem});
    }
  std::sort(sides.begin(), sides.end());
  return sides;
}

void measure_area_jumps(QuadMesh& mesh, const std::vector<double>& areas) {
  mesh.elem_area_jump.assign(mesh.num_elems(), 1.0);
  const std::vector<Side> sides = sorted_sides(mesh);
  for (std::size_t i = 1; i < sides.size(); ++i) {
    if (!sides[i].is_same_place(sides[i - 1])) continue;
    const int a = sides[i - 1].elem, b = sides[i].elem;
    const double jump = ratio_of(std::abs(areas[a]), std::abs(areas[b]));
    mesh.elem_area_jump[a] = std::max(mesh.elem_area_jump[a], jump);
    mesh.elem_area_jump[b] = std::max(mesh.elem_area_jump[b], jump);
  }
}

template <typename Point>
void measure_by(const std::vector<Point>& nodes, QuadMesh& mesh) {
  std::vector<double> areas;
  mesh.elem_edge_ratio.clear();
  mesh.elem_node_distance.clear();
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const ElementGrid grid(mesh, nodes, elem);
    mesh.elem_edge_ratio.push_back(edge_ratio(grid));
    mesh.elem_node_distance.push_back(grid.least_node_distance());
    areas.push_back(grid.area());
  }
  measure_area_jumps(mesh, areas);
}

}  // namespace

Vec2 centre(const QuadMesh& mesh, int elem) {
  Vec2 sum;
  for (int side = 0; side < 4; ++side) sum += mesh.nodes[side_start(mesh, elem, side)];
  return sum / 4;
}

void measure_element_sizes(QuadMesh& mesh) {
  mesh.space_nodes.empty() ? measure_by(mesh.nodes, mesh) : measure_by(mesh.space_nodes, mesh);
}

ElementSizes worst_element_sizes(const QuadMesh& mesh) {
  const auto index = [](const std::vector<double>& values, auto at) { return static_cast<int>(at - values.begin()); };
  ElementSizes worst;
  worst.edge_ratio_elem =
      index(mesh.elem_edge_ratio, std::max_element(mesh.elem_edge_ratio.begin(), mesh.elem_edge_ratio.end()));
  worst.area_jump_elem =
      index(mesh.elem_area_jump, std::max_element(mesh.elem_area_jump.begin(), mesh.elem_area_jump.end()));
  worst.node_distance_elem =
      index(mesh.elem_node_distance, std::min_element(mesh.elem_node_distance.begin(), mesh.elem_node_distance.end()));
  worst.edge_ratio = mesh.elem_edge_ratio[worst.edge_ratio_elem];
  worst.area_jump = mesh.elem_area_jump[worst.area_jump_elem];
  worst.node_distance = mesh.elem_node_distance[worst.node_distance_elem];
  worst.edge_ratio_position = centre(mesh, worst.edge_ratio_elem);
  worst.area_jump_position = centre(mesh, worst.area_jump_elem);
  worst.node_distance_position = centre(mesh, worst.node_distance_elem);
  return worst;
}

std::string describe(const ElementSizes& sizes, const CadFace& face) {
  return fmt::format(
      "greatest edge ratio {:.3g} at {}, greatest area jump {:.3g} at {}, least node distance {:.3g} at {}",
      sizes.edge_ratio, surface::position_text(face, sizes.edge_ratio_position), sizes.area_jump,
      surface::position_text(face, sizes.area_jump_position), sizes.node_distance,
      surface::position_text(face, sizes.node_distance_position));
}

void report_element_sizes(const QuadMesh& mesh, Report& report) {
  const ElementSizes worst = worst_element_sizes(mesh);
  const auto set = [&](const std::string& key, double value, int elem, Vec2 position) {
    report.set(key + ".value", value);
    report.set(key + ".element", elem);
    report.set(key + ".position", surface::position_in_file(mesh.face, position));
  };
  set("greatest_edge_ratio", worst.edge_ratio, worst.edge_ratio_elem, worst.edge_ratio_position);
  set("greatest_area_jump", worst.area_jump, worst.area_jump_elem, worst.area_jump_position);
  set("least_node_distance", worst.node_distance, worst.node_distance_elem, worst.node_distance_position);
}

namespace {

constexpr int extra_points = 5;  // R to about 1e-4 in curved elements

/// From the nodes of an element of order N to the Gauss points of each direction.
struct GaussTable {
  Eigen::MatrixXd weights;         ///< points x points
  Eigen::MatrixXd values, slopes;  ///< points x nodes; slopes with respect to [0, 1]

  explicit GaussTable(int order) {
    const spectral::Quadrature rule = spectral::gauss_legendre(order + extra_points);
    const std::vector<double>& nodes = spectral::gll_points(order);
    const Eigen::Map<const Eigen::VectorXd> along(rule.weights.data(), std::ssize(rule.weights));
    weights = along * along.transpose() / 4;
    values = spectral::interpolation_matrix(nodes, rule.points);
    slopes = 2 * values * spectral::differentiation_matrix(nodes);
  }
};

/// Of one element: not on the heap.
constexpr int most_points = 20 + extra_points;
using Nodes = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, most_points, most_points>;
using Values = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, most_points, most_points>;

/// A node of an element as its lengths are measured: in space, or in the plane in the metric of the element.
Vec3 measured_node(const QuadMesh& mesh, int elem, int node) {
  if (!mesh.space_nodes.empty()) return mesh.space_nodes[node];
  Vec2 x = mesh.nodes[node];
  if (!mesh.elem_prescribed_stretch.empty()) x = mesh.elem_prescribed_stretch[elem] * x;
  return {x.x, x.y, 0};
}

/// Of one element, lengths in units of `length`.
ElementPowers powers_of(const QuadMesh& mesh, int elem, double length) {
  const GaussTable& table = spectral::table_per_order<GaussTable>(mesh.order);
  const int width = mesh.order + 1;
  Nodes x(width, width), y(width, width), z(width, width);  // xi1 x xi2
  for (int k = 0; k < width * width; ++k) {
    const Vec3 node = measured_node(mesh, elem, mesh.elem_nodes[elem * width * width + k]) / length;
    x(k % width, k / width) = node.x, y(k % width, k / width) = node.y, z(k % width, k / width) = node.z;
  }
  const auto along = [](const Eigen::MatrixXd& of1, const Nodes& nodes, const Eigen::MatrixXd& of2) {
    const Nodes half = of1.lazyProduct(nodes);
    return Values(half.lazyProduct(of2.transpose()));
  };
  const Values x1 = along(table.slopes, x, table.values), y1 = along(table.slopes, y, table.values),
               x2 = along(table.values, x, table.slopes), y2 = along(table.values, y, table.slopes);
  const auto power = [&](const Values& squares, const Values& area) {
    return (squares.square().square() * area).sum();
  };
  if (mesh.space_nodes.empty()) {
    const Values area = (x1 * y2 - y1 * x2).abs() * table.weights.array();
    return {{power(x1.square() + y1.square(), area), power(x2.square() + y2.square(), area)}, area.sum()};
  }
  const Values z1 = along(table.slopes, z, table.values), z2 = along(table.values, z, table.slopes);
  const Values area =
      ((x1 * y2 - y1 * x2).square() + (y1 * z2 - z1 * y2).square() + (z1 * x2 - x1 * z2).square()).sqrt() *
      table.weights.array();
  return {{power(x1.square() + y1.square() + z1.square(), area), power(x2.square() + y2.square() + z2.square(), area)},
          area.sum()};
}

}  // namespace

double resolution_length(const QuadMesh& mesh, int elem) {
  return mesh.elem_prescribed_length.empty() ? mesh.face.diameter : mesh.elem_prescribed_length[elem];
}

Resolution resolution(const QuadMesh& mesh, const std::vector<Vec2>& greatest_lengths,
                      const std::vector<ElementPowers>& powers) {
  Resolution result{1, std::vector<std::array<double, 2>>(mesh.num_elems())};
  double total = 0, area = 0;
  int num = 0;
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const double length = resolution_length(mesh, elem);
    if (!(length > 0)) continue;
    const Vec2 greatest = greatest_lengths.empty() ? Vec2{length, length} : greatest_lengths[elem];
    const double x = std::min(1.0, greatest.x / length), y = std::min(1.0, greatest.y / length);
    const auto& [along, own_area] = powers[elem];
    result.parts[elem] = {along[0] / (std::pow(x, 2 * resolution_power) * x * y),
                          along[1] / (std::pow(y, 2 * resolution_power) * x * y)};
    total += result.parts[elem][0] + result.parts[elem][1];
    area += own_area / (x * y);
    ++num;
  }
  if (!(total > 0)) return result;
  result.ratio = total / (2 * area * std::pow(area / num, resolution_power));
  for (auto& parts : result.parts)
    for (double& part : parts) part /= total;
  return result;
}

std::vector<ElementPowers> element_powers(const QuadMesh& mesh) {
  std::vector<ElementPowers> powers(mesh.num_elems());
  for (int elem = 0; elem < mesh.num_elems(); ++elem)
    if (const double length = resolution_length(mesh, elem); length > 0) powers[elem] = powers_of(mesh, elem, length);
  return powers;
}

Resolution resolution(const QuadMesh& mesh, const std::vector<Vec2>& greatest_lengths) {
  return resolution(mesh, greatest_lengths, element_powers(mesh));
}

std::vector<double> relative_sizes(const QuadMesh& mesh) {
  std::vector<double> sizes;
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const double length = mesh.elem_prescribed_length[elem];
    sizes.push_back(length > 0 ? std::sqrt(powers_of(mesh, elem, length).area) : 1);
  }
  return sizes;
}

}  // namespace quadrille::mesh
