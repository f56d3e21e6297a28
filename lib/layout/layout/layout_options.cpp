#include "layout/layout_options.hpp"

#include <algorithm>

#include "base/angle.hpp"
#include "base/error.hpp"

namespace quadrille::layout {
namespace {

// Degrees by which lines of the coarsest layout may always deviate from the field, independent of the options.
constexpr double coarsest_deviation = 45;

}  // namespace

void LayoutOptions::validate() const {
  trace.validate();
  if (!(max_deviation >= 0)) throw UsageError("the greatest deviation must not be negative");
  if (max_lines < 1) throw UsageError("the greatest number of arcs must be positive");
}

simplify::SimplifyOptions simplify_options(const LayoutOptions& options) {
  simplify::SimplifyOptions simplify;
  simplify.limits_loss_by_saving = options.simplify != SimplifyLevel::coarsest;
  simplify.least_scaled_jacobian = simplify.limits_loss_by_saving ? 0.5 : 0.3;
  simplify.max_deviation =
      radians(options.simplify == SimplifyLevel::coarsest ? std::max(options.max_deviation, coarsest_deviation)
                                                          : options.max_deviation);
  return simplify;
}

}  // namespace quadrille::layout
