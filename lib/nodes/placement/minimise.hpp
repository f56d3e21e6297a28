#pragma once
// A minimum of a smooth function of some tens of variables whose gradient is expensive: BFGS far from the minimum,
// then Newton's method with a Hessian by differences of gradients, which does not depend on the accuracy of the values.
//
// BFGS starts from the identity, so that rotated variables (of one size) have rotated iterates. Steps have no component
// along directions without curvature: in these the result keeps the initial values.
//
// Source: J. Nocedal, S. J. Wright, Numerical Optimization, 2nd ed., ch. 3 and 6.

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
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
  double difference_step = 1e-5;     ///< of the differences of gradients
  double noise_allowance = 1e4;      ///< a last step below so many tolerances is the gradient's noise
};

struct Minimum {
  Eigen::VectorXd x;
  double value = 0;
  int iterations = 0, evaluations = 0;
  double last_step = 0;        ///< length of the last Newton step, limited by the noise of the gradient
  double least_curvature = 0;  ///< of the Hessian at the end, flat directions included
  bool is_converged = false;   ///< last_step <= tolerance
};

/// Throws Defect if the function does not exist at x.
Minimum minimise(const Minimand& f, const Eigen::VectorXd& x, const MinimiseOptions& options);

// The two halves of the minimiser.

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

/// BFGS for the inverse Hessian, from the identity or from the Hessian, until no entry of the gradient exceeds
/// `small_gradient`; false if no step leads to a lower value or the iterations are used up.
bool quasi_newton(Descent& descent, double small_gradient, bool from_identity);

/// Newton's method in the directions with curvature. Reuses one Hessian as long as steps shrink well; true if a minimum
/// is as near as the gradient's noise allows.
bool newton(Descent& descent);

}  // namespace quadrille::placement
