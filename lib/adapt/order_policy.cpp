#include "adapt/order_policy.hpp"

namespace quadrille::adapt {

OrderChange decide(double sensor, int order, bool was_raised, const AdaptOptions& options) {
  if (sensor > options.raise_above) return order < options.max_order ? OrderChange::raise : OrderChange::keep;
  if (sensor < options.lower_below && order > options.min_order && !was_raised) return OrderChange::lower;
  return OrderChange::keep;
}

}  // namespace quadrille::adapt
