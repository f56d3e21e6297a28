#include "placement/minimise.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"

namespace quadrille::placement {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The difference of gradients along variable i over its step; std::nullopt if the function exists on neither side.
std::optional<VectorXd> hessian_column(Descent& descent, Eigen::Index i) {
  for (const double step : {descent.options.difference_step, -descent.options.difference_step}) {
    VectorXd x = descent.found.x;
    x[i] += step;
    if (const auto sample = evaluate(descent, x)) return (sample->gradient - descent.here.gradient) / step;
  }
  return std::nullopt;
}

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

/// The Newton step in the directions with curvature.
VectorXd newton_step(const Descent& descent, const HessianModes& modes) {
  const VectorXd along = modes.solver.eigenvectors().transpose() * descent.here.gradient;
  VectorXd step = VectorXd::Zero(along.size());
  for (Eigen::Index i = 0; i < along.size(); ++i) {
    const double curvature = modes.solver.eigenvalues()[i];
    if (curvature > modes.clear) step -= along[i] / curvature * modes.solver.eigenvectors().col(i);
  }
  return step;
}

/// Takes the step and returns its length, if the whole step is allowed and leads nearer to the minimum.
std::optional<double> take(Descent& descent, const VectorXd& step) {
  const double length = descent.f.length(step);
  if (!std::isfinite(length) || descent.f.allowed(descent.found.x, step) < 1) return std::nullopt;
  const auto next = evaluate(descent, descent.found.x + step);
  const bool is_noise = length < descent.options.noise_allowance * descent.options.tolerance;
  if (!next || (!is_noise && next->gradient.norm() > descent.here.gradient.norm())) return std::nullopt;
  accept(descent, *next, step);
  descent.found.last_step = length;
  return length;
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

bool newton(Descent& descent) {
  const double tolerance = descent.options.tolerance;
  std::optional<HessianModes> modes;
  double before = std::numeric_limits<double>::infinity();
  for (int stalls = 0; stalls < 3;) {
    if (++descent.found.iterations > descent.options.max_iterations) return false;
    if (!modes) modes = hessian_modes(descent);
    if (!modes || modes->least() < -modes->clear) return false;
    const auto length = take(descent, newton_step(descent, *modes));
    if (!length) return false;
    if (*length <= tolerance) {
      descent.found.is_converged = modes->are_decided();
      if (descent.found.is_converged) return true;
      if (descent.here.gradient.norm() > 0.3 * modes->gradient) return false;
      modes.reset();
    } else if (*length > 0.1 * before) {
      ++stalls;
      modes.reset();
    }
    before = *length;
  }
  return descent.found.last_step < descent.options.noise_allowance * tolerance;
}

Minimum minimise(const Minimand& f, const Eigen::VectorXd& x, const MinimiseOptions& options) {
  Descent descent{f, options, {}, {}};
  descent.found.x = x;
  const auto sample = evaluate(descent, x);
  if (!sample) throw Defect("a minimum is sought from a point where the function does not exist");
  descent.here = *sample;
  Minimum& found = descent.found;
  found.is_converged = x.size() == 0;
  double newton_gradient = options.newton_gradient;
  bool is_first = !options.begins_with_hessian;
  while (found.iterations < options.max_iterations && !found.is_converged) {
    const bool was_down = quasi_newton(descent, newton_gradient, is_first);
    is_first = false;
    const bool is_near = newton(descent);
    if (is_near || !was_down) break;
    newton_gradient /= 30;
  }
  found.value = descent.here.value;
  return found;
}

}  // namespace quadrille::placement
