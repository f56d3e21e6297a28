#include "export/bezier_points.hpp"

#include "export/renode.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::exports {
namespace {

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

std::vector<Vec2> bezier_points(const QuadMesh& mesh) { return renoded(mesh, bernstein_at_gll(mesh.order).inverse()); }

}  // namespace quadrille::exports
