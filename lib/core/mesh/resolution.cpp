#include "mesh/resolution.hpp"

#include <cmath>

#include "spectral/lagrange.hpp"
#include "spectral/per_order.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::mesh {
namespace {

constexpr int extra_points = 5;  // R to about 1e-4 in curved elements

/// From the nodes of an element of order N to the Gauss points of each direction.
struct GaussTable {
  Eigen::VectorXd weights;
  Eigen::MatrixXd values, slopes;  ///< points x nodes; slopes with respect to [0, 1]

  explicit GaussTable(int order) {
    const spectral::Quadrature rule = spectral::gauss_legendre(order + extra_points);
    const std::vector<double>& nodes = spectral::gll_points(order);
    weights = Eigen::Map<const Eigen::VectorXd>(rule.weights.data(), std::ssize(rule.weights)) / 2;
    values = spectral::interpolation_matrix(nodes, rule.points);
    slopes = 2 * values * spectral::differentiation_matrix(nodes);
  }
};

Eigen::ArrayXXd fourth_power(const Eigen::ArrayXXd& square) { return square.square().square(); }

/// Of one element, lengths in units of `length`.
struct Sums {
  std::array<double, 2> powers{};  ///< E of each direction
  double area = 0;
};

Sums sums_of(const QuadMesh& mesh, int elem, double length) {
  const GaussTable& table = spectral::table_per_order<GaussTable>(mesh.order);
  const int width = mesh.order + 1;
  Eigen::MatrixXd x(width, width), y(width, width);  // xi1 x xi2
  for (int k = 0; k < width * width; ++k) {
    const Vec2 node = mesh.nodes[mesh.elem_nodes[elem * width * width + k]] / length;
    x(k % width, k / width) = node.x;
    y(k % width, k / width) = node.y;
  }
  const auto along = [](const Eigen::MatrixXd& of1, const Eigen::MatrixXd& nodes, const Eigen::MatrixXd& of2) {
    return Eigen::ArrayXXd(of1 * nodes * of2.transpose());
  };
  const Eigen::ArrayXXd x1 = along(table.slopes, x, table.values), y1 = along(table.slopes, y, table.values),
                        x2 = along(table.values, x, table.slopes), y2 = along(table.values, y, table.slopes);
  const Eigen::ArrayXXd area = (x1 * y2 - y1 * x2).abs() * (table.weights * table.weights.transpose()).array();
  return {
      {(fourth_power(x1.square() + y1.square()) * area).sum(), (fourth_power(x2.square() + y2.square()) * area).sum()},
      area.sum()};
}

}  // namespace

Resolution resolution(const QuadMesh& mesh) {
  const bool is_prescribed = !mesh.elem_prescribed_length.empty();
  Resolution result{1, std::vector<std::array<double, 2>>(mesh.num_elems())};
  double total = 0, area = 0;
  int num = 0;
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const double length = is_prescribed ? mesh.elem_prescribed_length[elem] : mesh.face.diameter;
    if (!(length > 0)) continue;
    const Sums sums = sums_of(mesh, elem, length);
    result.parts[elem] = sums.powers;
    total += sums.powers[0] + sums.powers[1];
    area += sums.area;
    ++num;
  }
  if (!(total > 0)) return result;
  result.ratio = total / (2 * area * std::pow(area / num, resolution_power));
  for (auto& parts : result.parts)
    for (double& part : parts) part /= total;
  return result;
}

std::vector<double> relative_sizes(const QuadMesh& mesh) {
  std::vector<double> sizes;
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const double length = mesh.elem_prescribed_length[elem];
    sizes.push_back(length > 0 ? std::sqrt(sums_of(mesh, elem, length).area) : 1);
  }
  return sizes;
}

}  // namespace quadrille::mesh
