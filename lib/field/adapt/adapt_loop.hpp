#pragma once
// Solves, evaluates the sensor and changes the order of each element, until no order changes: by prediction, or by
// Algorithm 1 of the paper.

#include "adapt/order_policy.hpp"
#include "base/report.hpp"
#include "model/field.hpp"

namespace quadrille::adapt {

/// Adapts until no order changes; each round is recorded in field.adapt_steps, its CPU time in the report alone (files
/// of equal runs are equal). If `start` has such a history, the loop continues it: several runs of one step each, with
/// the same options, equal one run. Estimates the errors of the result and warns if elements at max_order miss
/// target_error. A field of kind "phase" is adapted for its prescribed nodes, by the sensor of s alone.
Field adapt_loop(const Field& start, const AdaptOptions& options, Report& report);

}  // namespace quadrille::adapt
