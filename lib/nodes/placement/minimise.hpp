#pragma once
// A minimum of a smooth function of some tens of variables whose gradient is expensive: BFGS far from the minimum
// (placement/quasi_newton), then Newton's method with a Hessian by differences of gradients (placement/newton), which
// does not depend on the accuracy of the values.
//
// BFGS starts from the identity, so that rotated variables (of one size) have rotated iterates. Steps have no component
// along directions without curvature: in these the result keeps the initial values.
//
// Source: J. Nocedal, S. J. Wright, Numerical Optimization, 2nd ed., ch. 3 and 6.

#include "placement/minimand.hpp"

namespace quadrille::placement {

/// Throws Defect if the function does not exist at x.
Minimum minimise(const Minimand& f, const Eigen::VectorXd& x, const MinimiseOptions& options);

}  // namespace quadrille::placement
