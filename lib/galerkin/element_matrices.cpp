#include "galerkin/element_matrices.hpp"

#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "spectral/modified_basis.hpp"
#include "spectral/orthogonal_basis.hpp"
#include "spectral/per_order.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::galerkin {

namespace {

// Derivatives of the modified basis at the points of a collapsed Gauss rule.
struct GradientTable {
  std::vector<Vec2> points;
  std::vector<double> weights;
  Eigen::MatrixXd d1, d2;  // modes x points
};

GradientTable make_gradient_table(int order, int num_points) {
  const spectral::Quadrature along = spectral::gauss_legendre(num_points),
                             up = spectral::gauss_jacobi(num_points, 1, 0);
  const int n = spectral::num_tri_modes(order), total = num_points * num_points;
  GradientTable table;
  Eigen::VectorXd values(n);
  table.d1.resize(n, total);
  table.d2.resize(n, total);
  for (int i = 0, column = 0; i < num_points; ++i) {
    for (int j = 0; j < num_points; ++j, ++column) {
      const Vec2 xi{(1 + along.points[i]) * (1 - up.points[j]) / 2 - 1, up.points[j]};
      table.points.push_back(xi);
      table.weights.push_back(along.weights[i] * up.weights[j] / 2);
      spectral::modified_gradients(order, xi, values.data(), table.d1.col(column).data(), table.d2.col(column).data());
    }
  }
  return table;
}

const GradientTable& gradient_table(int order, int num_points) {
  static std::mutex mutex;
  static std::map<std::pair<int, int>, std::unique_ptr<GradientTable>> tables;
  const std::lock_guard lock(mutex);
  auto& entry = tables[{order, num_points}];
  if (!entry) entry = std::make_unique<GradientTable>(make_gradient_table(order, num_points));
  return *entry;
}

// The three reference matrices; the stiffness matrix of an affine element is a linear combination of them.
struct ReferenceMatrices {
  Eigen::MatrixXd k11, k12, k22;  // k12 contains both mixed products
};

// A A^T, both triangles.
Eigen::MatrixXd gram(const Eigen::MatrixXd& a) {
  Eigen::MatrixXd product = Eigen::MatrixXd::Zero(a.rows(), a.rows());
  product.selfadjointView<Eigen::Lower>().rankUpdate(a);
  product.triangularView<Eigen::StrictlyUpper>() = product.transpose();
  return product;
}

ReferenceMatrices make_reference_matrices(int order) {
  GradientTable table = make_gradient_table(order, order + 1);
  for (std::size_t i = 0; i < table.points.size(); ++i) {
    table.d1.col(i) *= std::sqrt(table.weights[i]);
    table.d2.col(i) *= std::sqrt(table.weights[i]);
  }
  // The mixed products are computed from the square of the sum: three symmetric products cost less than two symmetric
  // ones and a general one.
  ReferenceMatrices k{gram(table.d1), gram(table.d1 + table.d2), gram(table.d2)};
  k.k12 -= k.k11 + k.k22;
  return k;
}

const ReferenceMatrices& reference_matrices(int order) {
  static spectral::PerOrder<ReferenceMatrices> tables([](int n) {
    static spectral::PerOrder<ReferenceMatrices> large(make_reference_matrices);
    const int higher = spectral::table_order(n);
    const ReferenceMatrices& all = large[higher];
    return ReferenceMatrices{cut_down(all.k11, higher, n), cut_down(all.k12, higher, n), cut_down(all.k22, higher, n)};
  });
  return tables[order];
}

Eigen::MatrixXd affine_stiffness(const spectral::TriMap& map, int order) {
  Vec2 x;
  Mat2 j;
  map.evaluate({0, 0}, x, j);
  const double d = det(j);
  // |J| J^-1 J^-T: the metric that couples the reference derivatives.
  const double g11 = (j.xy * j.xy + j.yy * j.yy) / d, g22 = (j.xx * j.xx + j.yx * j.yx) / d;
  const double g12 = -(j.xx * j.xy + j.yx * j.yy) / d;
  const ReferenceMatrices& reference = reference_matrices(order);
  return g11 * reference.k11 + g12 * reference.k12 + g22 * reference.k22;
}

Eigen::MatrixXd curved_stiffness(const spectral::TriMap& map, int order, int num_points) {
  const GradientTable& table = gradient_table(order, num_points);
  const int n = static_cast<int>(table.d1.rows()), total = static_cast<int>(table.points.size());
  Eigen::MatrixXd gradients(n, 2 * total);  // physical derivatives times sqrt(weight det J)
  for (int i = 0; i < total; ++i) {
    Vec2 x;
    Mat2 j;
    map.evaluate(table.points[i], x, j);
    const double scale = std::sqrt(table.weights[i] / det(j));
    gradients.col(2 * i) = (scale * j.yy) * table.d1.col(i) - (scale * j.yx) * table.d2.col(i);
    gradients.col(2 * i + 1) = (scale * j.xx) * table.d2.col(i) - (scale * j.xy) * table.d1.col(i);
  }
  return gram(gradients);
}

}  // namespace

Eigen::MatrixXd stiffness_matrix(const spectral::TriMap& map, int order, int extra_points) {
  return map.is_affine() ? affine_stiffness(map, order) : curved_stiffness(map, order, order + extra_points);
}

Eigen::MatrixXd cut_down(const Eigen::MatrixXd& stiffness, int higher_order, int order) {
  if (order == higher_order) return stiffness;
  const std::vector<int>& modes = spectral::modified_subset(order, higher_order);
  return stiffness(modes, modes);
}

}  // namespace quadrille::galerkin
