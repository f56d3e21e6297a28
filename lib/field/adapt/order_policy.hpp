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

/// Whether no sensor of an element exceeds the limit, or at most one of 1000, each at most tenfold: a field is not
/// worth another solution of all elements for these, and the error estimate contains what they leave.
bool is_good_enough(const std::vector<double>& sensors, double limit);

/// The order, not rounded, at which the sensor of an element reaches `target`: where its modes already do, interpolated
/// between two degrees; else extrapolated at `trusted_rate` times the rate at which they decay over the last degrees,
/// times the ratio of that rate to the one before: the decay of smooth fields accelerates, that of rough ones slows
/// down. `sensors`: by degree (adapt/sensor). The maximum over all higher degrees stands for each degree, because by
/// symmetry every other degree may vanish; so the highest degree, which may vanish, is extrapolated too but never
/// lowers the result: where the decay slows down at that degree, it is the only sign of it.
double predicted_order(const std::vector<double>& sensors, double target, double trusted_rate);

}  // namespace quadrille::adapt
