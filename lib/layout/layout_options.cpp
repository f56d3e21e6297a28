#include "layout/layout_options.hpp"

#include <algorithm>

#include "base/angle.hpp"
#include "base/error.hpp"

namespace quadrille::layout {
namespace {

// Degrees that the coarsest layout may turn its lines away from the field, whatever the options say.
constexpr double coarsest_turn = 45;

}  // namespace

void LayoutOptions::validate() const {
  trace.validate();
  if (max_turn < 0) throw UsageError("the greatest turn must not be negative");
  if (max_lines < 1) throw UsageError("the bounds must be positive");
}

simplify::SimplifyOptions simplify_options(const LayoutOptions& options) {
  simplify::SimplifyOptions simplify;
  simplify.limits_loss_by_saving = options.simplify != "coarsest";
  simplify.least_scaled_jacobian = simplify.limits_loss_by_saving ? 0.5 : 0.3;
  simplify.max_deviation =
      radians(options.simplify == "coarsest" ? std::max(options.max_turn, coarsest_turn) : options.max_turn);
  return simplify;
}

}  // namespace quadrille::layout
