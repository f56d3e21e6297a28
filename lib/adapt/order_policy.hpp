#pragma once
// What one round of Algorithm 1 does to the order of an element: the decision table.

#include <vector>

#include "adapt/adapt_options.hpp"

namespace quadrille::adapt {

enum class OrderChange { lower = -1, keep = 0, raise = 1 };

/// Raise when the sensor exceeds raise_above and the order is below max_order; lower when it is below lower_below, the
/// order is above min_order and the element has never been raised, so that no element goes up and down for ever.
OrderChange decide(double sensor, int order, bool was_raised, const AdaptOptions& options);

}  // namespace quadrille::adapt
