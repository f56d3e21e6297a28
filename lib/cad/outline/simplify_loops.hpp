#pragma once
// Replaces splines with many knots by splines with few (curve/simplify_spline.hpp).

#include <vector>

#include "base/report.hpp"
#include "heal/loop.hpp"
#include "model/repair.hpp"

namespace quadrille::outline {

/// Simplifies the curves of the loops; `tolerance`: the most that they may move, in diameters (0: none is simplified),
/// `diameter`: of the face, a length. Adds a repair of kind `fit` for each curve that was replaced, also to the report,
/// with the keys fit.*. Returns the greatest distance by which a curve moved, a length.
double simplify_loops(std::vector<heal::Loop>& loops, double tolerance, double diameter, std::vector<Repair>& repairs,
                      Report& report);

}  // namespace quadrille::outline
