#pragma once
// The function that placement/minimise minimises, the options and the result.

#include <Eigen/Core>
#include <functional>
#include <optional>

namespace quadrille::placement {

struct Minimand {
  struct Sample {
    double value = 0;
    Eigen::VectorXd gradient;
  };
  /// Value and gradient at x; std::nullopt if the function does not exist there.
  std::function<std::optional<Sample>(const Eigen::VectorXd& x)> sample;
  /// The largest fraction in (0, 1] of `step` that is allowed from x at once.
  std::function<double(const Eigen::VectorXd& x, const Eigen::VectorXd& step)> allowed;
  /// The length of a step, in the unit of the tolerance.
  std::function<double(const Eigen::VectorXd& step)> length;
};

struct MinimiseOptions {
  double tolerance = 1e-10;          ///< length of the last Newton step
  int max_iterations = 200;          ///< of both methods together
  double newton_gradient = 1e-2;     ///< Newton's method is tried if no entry of the gradient is greater
  bool begins_with_hessian = false;  ///< BFGS starts from the Hessian, not the identity: if badly scaled
  double flat_curvature = 1e-5;      ///< relative to the largest curvature: directions below count as flat
};

struct Minimum {
  Eigen::VectorXd x;
  double value = 0;
  int iterations = 0, evaluations = 0;
  double last_step = 0;        ///< length of the last Newton step, limited by the noise of the gradient
  double least_curvature = 0;  ///< of the Hessian at the end, flat directions included
  bool is_converged = false;   ///< last_step <= tolerance
};

}  // namespace quadrille::placement
