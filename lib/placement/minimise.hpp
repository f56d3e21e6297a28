#pragma once
// A minimum of a smooth function of some tens of variables whose gradient is expensive: BFGS from far
// (placement/quasi_newton), then Newton's method with a Hessian by differences of gradients (placement/newton), which
// does not depend on the accuracy of the values.
//
// BFGS starts from the identity, so that in variables of one size, turned by a rotation, the iterates are the turned
// ones. Steps have no component along directions without curvature: there the answer keeps what it started with.
//
// Source: J. Nocedal, S. J. Wright, Numerical Optimization, 2nd ed., ch. 3 and 6.

#include "placement/minimand.hpp"

namespace quadrille::placement {

/// Throws Defect where the function does not exist at x.
Minimum minimise(const Minimand& f, const Eigen::VectorXd& x, const MinimiseOptions& options);

}  // namespace quadrille::placement
