#pragma once
// What placement/minimise minimises, with which options, and its result.

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
  /// The largest part in (0, 1] of `step` that may be taken from x at once.
  std::function<double(const Eigen::VectorXd& x, const Eigen::VectorXd& step)> allowed;
  /// How long a step is, in the unit of the tolerance.
  std::function<double(const Eigen::VectorXd& step)> length;
};

struct MinimiseOptions {
  double tolerance = 1e-10;          ///< length of the last Newton step
  int max_iterations = 200;          ///< of both methods together
  double newton_gradient = 1e-2;     ///< greatest entry of the gradient with which Newton's method is tried
  bool begins_with_hessian = false;  ///< BFGS too, instead of with the identity: for functions that are badly scaled
  double flat_curvature = 1e-5;      ///< part of the largest curvature below which a direction counts as flat
};

struct Minimum {
  Eigen::VectorXd x;
  double value = 0;
  int iterations = 0, evaluations = 0;
  double last_step = 0;        ///< length of the last Newton step; what the noise of the gradient leaves
  double least_curvature = 0;  ///< of the Hessian at the end, flat directions included
  bool is_converged = false;   ///< last_step <= tolerance
};

}  // namespace quadrille::placement
