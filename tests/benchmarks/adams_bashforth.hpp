#pragma once
// The integrator of the paper: the four-step Adams-Bashforth method in physical space with a fixed step,
//
//   x_(n+1) = x_n + h / 24 (55 f_n - 59 f_(n-1) + 37 f_(n-2) - 9 f_(n-3)),   f = e(psi'(x)),
//
// started by three steps of the classical Runge-Kutta method. Every evaluation has to find its element, by a walk from
// the previous one, and its reference coordinates, by Newton's method. It serves only as a reference for
// trace/advance.hpp: it estimates no error, and its order is reduced in steps across an element's edge, where the field
// is only continuous.

#include "trace/advance.hpp"

namespace quadrille::trace {

/// Follows a launched line with steps of options.max_step; ends as advance() does, but ends in a node only where a step
/// ends within options.hit_distance of it. Positions between the steps are cubics. Throws ComputeError if the field
/// vanishes or a step ends outside the domain without crossing the boundary.
Streamline advance_adams_bashforth(const field::FieldEvaluator& evaluator, const Launch& launch, const PointGrid& nodes,
                                   const AdvanceOptions& options);

}  // namespace quadrille::trace
