#pragma once
// The second half of the minimiser: Newton's method in the directions with curvature.

#include "placement/descent.hpp"

namespace quadrille::placement {

/// Reuses one Hessian as long as steps shrink well; true if a minimum is as near as the gradient's noise allows.
bool newton(Descent& descent);

}  // namespace quadrille::placement
