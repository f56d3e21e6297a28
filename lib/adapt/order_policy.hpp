#pragma once
// Decision table of Algorithm 1: how one round changes the order of an element.

#include <vector>

#include "adapt/adapt_options.hpp"

namespace quadrille::adapt {

enum class OrderChange { lower = -1, keep = 0, raise = 1 };

/// Raise when the sensor exceeds raise_above and the order is below max_order; lower when it is below lower_below, the
/// order is above min_order and the element has never been raised, so that no order oscillates.
OrderChange decide(double sensor, int order, bool was_raised, const AdaptOptions& options);

}  // namespace quadrille::adapt
