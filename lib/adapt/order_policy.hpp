#pragma once
// How one round changes the order of an element: the decision table of Algorithm 1, and the prediction from the decay
// of its modes.

#include <vector>

#include "adapt/adapt_options.hpp"

namespace quadrille::adapt {

enum class OrderChange { lower = -1, keep = 0, raise = 1 };

/// Raise when the sensor exceeds raise_above and the order is below max_order; lower when it is below lower_below, the
/// order is above min_order and the element has never been raised, so that no order oscillates.
OrderChange decide(double sensor, int order, bool was_raised, const AdaptOptions& options);

/// The order, not rounded, at which the sensor of an element reaches `target`: where its modes already do, interpolated
/// between two degrees; else extrapolated at `trusted_rate` times the rate at which they decay over the last degrees,
/// times the ratio of that rate to the one before: the decay of smooth fields accelerates, that of rough ones slows
/// down. `sensors`: by degree (adapt/sensor). The maximum over all higher degrees stands for each degree, because by
/// symmetry every other degree may vanish; so the highest degree decides nothing alone.
double predicted_order(const std::vector<double>& sensors, double target, double trusted_rate);

}  // namespace quadrille::adapt
