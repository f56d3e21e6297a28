#pragma once
// The paper's Algorithm 1: solve, sense, raise or lower the order of each element, until nothing changes.

#include <string>

#include "base/report.hpp"
#include "model/field.hpp"

namespace quadrille::adapt {

struct AdaptOptions {
  double raise_above = 1e-18;         ///< epsilon_u on the squared sensor S_e
  double lower_below = 1e-24;         ///< epsilon_l, below raise_above
  int num_threads = 1;                ///< the result does not depend on it
  int min_order = 2, max_order = 20;  ///< a "dg" field goes up to max_field_order at most
  int max_steps = 20;                 ///< bound on new solutions; reaching it is a warning
  double target_error = 1e-8;         ///< |v - v_h| that elements at max_order should reach; missing it is a warning
  std::string sensor = "vector";      ///< "vector", "u" or "v"
  std::string scale = "absolute";     ///< of the sensor: "absolute" or "relative"
  void validate() const;              ///< throws UsageError
};

/// Adapts until no order changes; each round is recorded in field.adapt_steps, its CPU time in the report alone (files
/// of equal runs are equal). A field that has such a history goes on from its end: many runs of one step each, with the
/// same options, are one run. Estimates the errors of the result and warns where elements at max_order miss
/// target_error. A field of kind "phase" is adapted for its nodes, by the sensor of s alone.
Field adapt_loop(const Field& start, const AdaptOptions& options, Report& report);

}  // namespace quadrille::adapt
