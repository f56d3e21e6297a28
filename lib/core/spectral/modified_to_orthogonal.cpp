#include "spectral/modified_to_orthogonal.hpp"

#include <cmath>

#include "spectral/factored_modes.hpp"
#include "spectral/jacobi.hpp"
#include "spectral/modified_basis.hpp"
#include "spectral/orthogonal_basis.hpp"
#include "spectral/per_order.hpp"

namespace quadrille::spectral {

namespace {

// Points eta2 x degrees q = 0..order - p: the factor of eta2 of the orthogonal modes (p, q), times the weight.
Eigen::MatrixXd weighted_orthogonal_factors(int order, int p, const Quadrature& eta2) {
  const int num_points = static_cast<int>(eta2.points.size());
  Eigen::MatrixXd values(num_points, order - p + 1);
  for (int j = 0; j < num_points; ++j) {
    const double t = std::pow((1 - eta2.points[j]) / 2, p) * eta2.weights[j] / 2;
    for (int q = 0; q <= order - p; ++q)
      values(j, q) = t * orthogonal_scale(p, q) * jacobi(q, 2 * p + 1, 0, eta2.points[j]);
  }
  return values;
}

// The integral of f_c P_p is zero but for p up to the degree of f_c, and for f_{3+i}, which is (1 - eta1^2) P_i^(1,1),
// but for p = i and i + 2. The products in eta2 have degree 2 P, for which P + 1 points are exact.
Eigen::MatrixXd make_to_orthogonal(int order) {
  const FactoredModes modes = factored_modes(order, order + 1);
  Eigen::MatrixXd table = Eigen::MatrixXd::Zero(num_tri_modes(order), num_tri_modes(order));
  for (int p = 0; p <= order; ++p) {
    const Eigen::MatrixXd orthogonal = weighted_orthogonal_factors(order, p, modes.eta2);
    for (int c = 0; c < modes.num_factors(); ++c) {
      const int degree = c < 3 ? (c + 1) / 2 : c - 1;
      if (p > degree || (c >= 3 && p != degree && p != degree - 2)) continue;
      double integral = 0;
      for (std::size_t i = 0; i < modes.eta1.points.size(); ++i)
        integral += modes.eta1.weights[i] * modes.f(i, c) * jacobi(p, 0, 0, modes.eta1.points[i]);
      const Eigen::MatrixXd block =
          integral * modes.g.middleCols(modes.first[c], modes.num_modes(c)).transpose() * orthogonal;
      for (int row = 0; row < block.rows(); ++row)
        for (int q = 0; q < block.cols(); ++q)
          table(modes.position[modes.first[c] + row], (p + q) * (p + q + 1) / 2 + p) = block(row, q);
    }
  }
  return table;
}

}  // namespace

const Eigen::MatrixXd& modified_to_orthogonal(int order) {
  static PerOrder<Eigen::MatrixXd> tables([](int n) {
    static PerOrder<Eigen::MatrixXd> large(make_to_orthogonal);
    const int higher = table_order(n);
    return Eigen::MatrixXd(large[higher](modified_subset(n, higher), Eigen::seqN(0, num_tri_modes(n))));
  });
  return tables[order];
}

}  // namespace quadrille::spectral
