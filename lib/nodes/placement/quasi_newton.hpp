#pragma once
// The first half of the minimiser: BFGS with a line search.

#include "placement/descent.hpp"

namespace quadrille::placement {

/// BFGS for the inverse Hessian, from the identity or from the Hessian, until no entry of the gradient exceeds
/// `small_gradient`; false if no step leads to a lower value or the iterations are used up.
bool quasi_newton(Descent& descent, double small_gradient, bool from_identity);

}  // namespace quadrille::placement
