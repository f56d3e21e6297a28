#include "refine/shape_energy.hpp"

#include <cmath>
#include <limits>

#include "spectral/lagrange.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::refine {
namespace {

constexpr int power = 4;

double power_of(double mu) { return mu * mu * mu * mu; }
static_assert(power == 4);

}  // namespace

ShapeEnergy::ShapeEnergy(const QuadMesh& mesh)
    : order_(mesh.order),
      elem_nodes_(mesh.elem_nodes),
      derivative_(spectral::differentiation_matrix(spectral::gll_points(mesh.order))) {
  inverse_lengths_.reserve(mesh.elem_nodes.size());
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const Jacobians j = jacobians(elem, mesh.nodes);
    for (Eigen::Index k = 0; k < j.x1.size(); ++k)
      inverse_lengths_.push_back(
          {1 / std::hypot(j.x1.data()[k], j.y1.data()[k]), 1 / std::hypot(j.x2.data()[k], j.y2.data()[k])});
  }
}

ShapeEnergy::Jacobians ShapeEnergy::jacobians(int elem, const std::vector<Vec2>& nodes) const {
  const int width = order_ + 1, count = width * width;
  Eigen::MatrixXd x(width, width), y(width, width);
  const Vec2 start = nodes[elem_nodes_[elem * count]];
  for (int k = 0; k < count; ++k) {
    const Vec2 node = nodes[elem_nodes_[elem * count + k]] - start;
    x.data()[k] = node.x;
    y.data()[k] = node.y;
  }
  return {derivative_ * x, x * derivative_.transpose(), derivative_ * y, y * derivative_.transpose()};
}

double ShapeEnergy::value(int elem, const std::vector<Vec2>& nodes) const {
  const Jacobians j = jacobians(elem, nodes);
  const Eigen::Index count = j.x1.size();
  double sum = 0;
  for (Eigen::Index k = 0; k < count; ++k) {
    const Vec2 scale = inverse_lengths_[elem * count + k];
    const Vec2 a = scale.x * Vec2{j.x1.data()[k], j.y1.data()[k]}, b = scale.y * Vec2{j.x2.data()[k], j.y2.data()[k]};
    const double det = cross(a, b);
    if (!(det > 0)) return std::numeric_limits<double>::infinity();
    sum += power_of((norm2(a) + norm2(b)) / (2 * det));
  }
  return sum / static_cast<double>(count);
}

ElementEnergy ShapeEnergy::with_derivatives(int elem, const std::vector<Vec2>& nodes) const {
  const Jacobians j = jacobians(elem, nodes);
  const int width = order_ + 1, count = width * width;
  const std::vector<double>& xi = spectral::gll_points(order_);
  const std::array<Vec2, 4> corners{Vec2{-1, -1}, Vec2{1, -1}, Vec2{1, 1}, Vec2{-1, 1}};
  ElementEnergy energy;
  for (int k = 0; k < count; ++k) {
    const Vec2 scale = inverse_lengths_[elem * count + k];
    const Vec2 a = scale.x * Vec2{j.x1.data()[k], j.y1.data()[k]}, b = scale.y * Vec2{j.x2.data()[k], j.y2.data()[k]};
    const double det = cross(a, b), mu = (norm2(a) + norm2(b)) / (2 * det);
    const double weight = 1.0 / count, slope = weight * power * mu * mu * mu, bend = weight * 12 * mu * mu;
    energy.value += weight * power_of(mu);
    const Vec2 by_a = (a - mu * Vec2{b.y, -b.x}) / det, by_b = (b - mu * Vec2{-a.y, a.x}) / det;
    for (int c = 0; c < 4; ++c) {
      const double d1 = scale.x * corners[c].x * (1 + corners[c].y * xi[k / width]) / 4;
      const double d2 = scale.y * corners[c].y * (1 + corners[c].x * xi[k % width]) / 4;
      const Vec2 g = d1 * by_a + d2 * by_b;
      const double round = slope * (d1 * d1 + d2 * d2) / det;
      energy.gradient[c] += slope * g;
      energy.hessian[c][0] += round + bend * g.x * g.x;
      energy.hessian[c][1] += bend * g.x * g.y;
      energy.hessian[c][2] += round + bend * g.y * g.y;
    }
  }
  return energy;
}

}  // namespace quadrille::refine
