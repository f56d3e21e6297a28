#pragma once
// The paper's way to trace a line: the four-step Adams-Bashforth method in physical space with a fixed step,
//
//   x_(n+1) = x_n + h / 24 (55 f_n - 59 f_(n-1) + 37 f_(n-2) - 9 f_(n-3)),   f = e(psi'(x)),
//
// begun by three steps of the classical Runge-Kutta method. Every evaluation has to find its element, by a walk from
// the one before, and its reference coordinates, by Newton's method. A yardstick for trace/advance.hpp and nothing
// else: it knows no error, and a step across an element's edge, where the field is no more than continuous, costs it
// its order.

#include "trace/advance.hpp"

namespace quadrille::trace {

/// Follows a launched line with steps of options.max_step; ends as advance() does, but meets a node only where a step
/// ends within options.hit_distance of it. Positions between the steps are cubics. Throws ComputeError where the field
/// vanishes or a step jumps out of the domain and no boundary lies between.
Streamline advance_adams_bashforth(const field::FieldEvaluator& evaluator, const Launch& launch,
                                   const std::vector<Vec2>& nodes, const AdvanceOptions& options);

}  // namespace quadrille::trace
