#include "placement/quasi_newton.hpp"

#include <cmath>

namespace quadrille::placement {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Near the minimum, values no longer distinguish descent from noise; the slope along the step still does.
bool leads_down(const Descent& descent, const Minimand::Sample& next, const VectorXd& step, double slope) {
  const double value = descent.here.value, noise = 1e-9 * (1 + std::abs(value));
  if (next.value <= value + 1e-4 * slope && slope < -noise) return true;
  return next.value <= value + noise && std::abs(next.gradient.dot(step)) <= std::abs(slope);
}

/// Shortens the step until it leads to a lower value; std::nullopt if no length does.
std::optional<Minimand::Sample> line_search(Descent& descent, VectorXd& step) {
  step *= descent.f.allowed(descent.found.x, step);
  for (int halving = 0; halving < 40; ++halving, step /= 2) {
    auto next = evaluate(descent, descent.found.x + step);
    if (next && leads_down(descent, *next, step, descent.here.gradient.dot(step))) return next;
  }
  return std::nullopt;
}

/// The inverse of the Hessian with the absolute values of its curvatures, so that its steps are descent directions.
MatrixXd inverse_hessian(Descent& descent) {
  const auto n = descent.found.x.size();
  const auto modes = hessian_modes(descent);
  if (!modes) return MatrixXd::Identity(n, n);
  const VectorXd curvatures = modes->solver.eigenvalues().cwiseAbs().cwiseMax(10 * modes->flat);
  const MatrixXd& vectors = modes->solver.eigenvectors();
  return vectors * curvatures.cwiseInverse().asDiagonal() * vectors.transpose();
}

/// The BFGS update after `step` changed the gradient by `change`; `bend` is their scalar product.
void update(MatrixXd& inverse, const VectorXd& step, const VectorXd& change, double bend) {
  const VectorXd image = inverse * change;
  inverse += (1 + change.dot(image) / bend) / bend * step * step.transpose() -
             (image * step.transpose() + step * image.transpose()) / bend;
}

double greatest_entry(const VectorXd& gradient) { return gradient.lpNorm<Eigen::Infinity>(); }

}  // namespace

bool quasi_newton(Descent& descent, double small_gradient, bool from_identity) {
  if (greatest_entry(descent.here.gradient) <= small_gradient) return true;
  const auto n = descent.found.x.size();
  MatrixXd inverse = from_identity ? MatrixXd::Identity(n, n) : inverse_hessian(descent);
  bool is_scaled = !from_identity;
  while (greatest_entry(descent.here.gradient) > small_gradient) {
    if (++descent.found.iterations > descent.options.max_iterations) return false;
    VectorXd step = -inverse * descent.here.gradient;
    const auto next = line_search(descent, step);
    if (!next) return false;
    const VectorXd change = next->gradient - descent.here.gradient;
    const double bend = step.dot(change);
    accept(descent, *next, step);
    if (bend <= 1e-12 * step.norm() * change.norm()) continue;
    if (!is_scaled) inverse *= bend / change.squaredNorm();
    is_scaled = true;
    update(inverse, step, change, bend);
  }
  return true;
}

}  // namespace quadrille::placement
