#include "placement/descent.hpp"

#include <algorithm>

namespace quadrille::placement {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double difference_step = 1e-5;

/// The difference of gradients along variable i over its step; std::nullopt if the function exists on neither side.
std::optional<VectorXd> hessian_column(Descent& descent, Eigen::Index i) {
  for (const double step : {difference_step, -difference_step}) {
    VectorXd x = descent.found.x;
    x[i] += step;
    if (const auto sample = evaluate(descent, x)) return (sample->gradient - descent.here.gradient) / step;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Minimand::Sample> evaluate(Descent& descent, const VectorXd& x) {
  ++descent.found.evaluations;
  return descent.f.sample(x);
}

void accept(Descent& descent, const Minimand::Sample& next, const VectorXd& step) {
  descent.found.x += step;
  descent.here = next;
}

std::optional<HessianModes> hessian_modes(Descent& descent) {
  const auto n = descent.found.x.size();
  MatrixXd h(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto column = hessian_column(descent, i);
    if (!column) return std::nullopt;
    h.col(i) = *column;
  }
  const MatrixXd symmetric = (h + h.transpose()) / 2;
  HessianModes modes;
  modes.solver.compute(symmetric);
  modes.gradient = descent.here.gradient.norm();
  modes.flat = descent.options.flat_curvature * modes.solver.eigenvalues().cwiseAbs().maxCoeff();
  modes.clear = std::max(modes.flat, 3 * modes.gradient);
  descent.found.least_curvature = modes.least();
  return modes;
}

}  // namespace quadrille::placement
