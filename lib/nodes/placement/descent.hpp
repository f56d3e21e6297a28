#pragma once
// The state on which both halves of the minimiser (placement/quasi_newton, placement/newton) work: point and counts.

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <optional>

#include "placement/minimand.hpp"

namespace quadrille::placement {

/// The function, the options and the point reached so far.
struct Descent {
  const Minimand& f;
  const MinimiseOptions& options;
  Minimum found;
  Minimand::Sample here;  ///< value and gradient at found.x
};

/// The eigenvalues (curvatures) and eigenvectors of the Hessian at a point.
struct HessianModes {
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  double gradient = 0;  ///< norm of the gradient there
  double flat = 0;      ///< curvatures of at most this magnitude count as 0
  double clear = 0;     ///< curvatures above this are positive: a flat direction that bends appears to have up to |g|

  double least() const { return solver.eigenvalues()[0]; }
  /// Whether each curvature is either flat or clearly positive.
  bool are_decided() const {
    return ((solver.eigenvalues().array().abs() <= flat) || (solver.eigenvalues().array() > clear)).all();
  }
};

/// Samples the function at x and counts the evaluation; std::nullopt if the function does not exist there.
std::optional<Minimand::Sample> evaluate(Descent& descent, const Eigen::VectorXd& x);

/// Moves to found.x + step, where `next` is the sample.
void accept(Descent& descent, const Minimand::Sample& next, const Eigen::VectorXd& step);

/// By differences of gradients, forward ones if they exist; std::nullopt if the function exists on neither side.
std::optional<HessianModes> hessian_modes(Descent& descent);

}  // namespace quadrille::placement
