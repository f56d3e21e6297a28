#pragma once
// A minimum of a smooth function of some tens of variables whose gradient is dear: BFGS from far, then Newton's method
// with a Hessian by differences of gradients, which asks nothing of the accuracy of the values.
//
// Both start from the identity, so in variables that are of one size and turned by a rotation the iterates are the
// turned ones. Directions without curvature are not walked along: there the answer keeps what it started with.
//
// Source: J. Nocedal, S. J. Wright, Numerical Optimization, 2nd ed., ch. 3 and 6.

#include <Eigen/Core>
#include <functional>
#include <optional>

namespace quadrille::placement {

struct Minimand {
  struct Sample {
    double value = 0;
    Eigen::VectorXd gradient;
  };
  /// Nothing where the function does not exist.
  std::function<std::optional<Sample>(const Eigen::VectorXd& x)> sample;
  /// The largest share in (0, 1] of `step` that may be gone from x at once.
  std::function<double(const Eigen::VectorXd& x, const Eigen::VectorXd& step)> allowed;
  /// How long a step is, in the unit of the tolerance.
  std::function<double(const Eigen::VectorXd& step)> length;
};

struct MinimiseOptions {
  double tolerance = 1e-10;          ///< length of the last Newton step
  int max_iterations = 200;          ///< of either method
  double newton_gradient = 1e-2;     ///< greatest entry of the gradient with which Newton's method is tried
  bool begins_with_hessian = false;  ///< BFGS too, instead of with the identity; for what has proved badly scaled
  double flat_curvature = 1e-5;      ///< share of the largest curvature below which a direction counts as flat
};

struct Minimum {
  Eigen::VectorXd x;
  double value = 0;
  int iterations = 0, evaluations = 0;
  double last_step = 0;        ///< length of the last Newton step; what the noise of the gradient leaves
  double least_curvature = 0;  ///< of the Hessian at the end, flat directions included
  bool is_converged = false;   ///< last_step <= tolerance
};

/// Throws Defect where the function does not exist at x.
Minimum minimise(const Minimand& f, const Eigen::VectorXd& x, const MinimiseOptions& options);

}  // namespace quadrille::placement
