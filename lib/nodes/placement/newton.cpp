#include "placement/newton.hpp"

#include <cmath>
#include <limits>

namespace quadrille::placement {
namespace {

using Eigen::VectorXd;

constexpr double noise_allowance = 1e4;  // a last step below so many tolerances is the gradient's noise

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
  const bool is_noise = length < noise_allowance * descent.options.tolerance;
  if (!next || (!is_noise && next->gradient.norm() > descent.here.gradient.norm())) return std::nullopt;
  accept(descent, *next, step);
  descent.found.last_step = length;
  return length;
}

}  // namespace

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
  return descent.found.last_step < noise_allowance * tolerance;
}

}  // namespace quadrille::placement
