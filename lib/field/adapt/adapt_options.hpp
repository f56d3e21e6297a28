#pragma once
// Options of the adaptation of orders.

#include <array>

#include "adapt/sensor.hpp"
#include "base/enum_names.hpp"

namespace quadrille::adapt {

/// How orders follow from the sensors.
enum class AdaptPolicy {
  predict,  ///< to the order that the decay of the modes predicts; later rounds only raise
  paper     ///< by one in each round: Algorithm 1 of the paper
};
constexpr auto enum_names(AdaptPolicy) { return std::to_array({"predict", "paper"}); }

struct AdaptOptions {
  AdaptPolicy policy = AdaptPolicy::predict;
  double raise_above = 1e-16;         ///< epsilon_u on the squared sensor S_e
  double lower_below = 1e-22;         ///< epsilon_l, below raise_above
  int num_threads = 1;                ///< the result does not depend on it
  int min_order = 2, max_order = 20;  ///< at most max_field_order of the field's method
  int max_steps = 20;                 ///< greatest number of new solutions; reaching it causes a warning
  double target_error = 1e-8;         ///< on |v - v_h|; elements at max_order that miss it cause a warning
  SensorKind sensor = SensorKind::vector;
  SensorScale scale = SensorScale::absolute;
  void validate() const;  ///< throws UsageError
};

}  // namespace quadrille::adapt
