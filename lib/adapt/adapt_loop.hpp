#pragma once
// The paper's Algorithm 1: solve, sense, raise or lower the order of each element, until nothing changes.

#include "adapt/adapt_options.hpp"
#include "base/report.hpp"
#include "model/field.hpp"

namespace quadrille::adapt {

/// Adapts until no order changes; each round is recorded in field.adapt_steps, its CPU time in the report alone (files
/// of equal runs are equal). A field that has such a history goes on from its end: many runs of one step each, with the
/// same options, are one run. Estimates the errors of the result and warns where elements at max_order miss
/// target_error. A field of kind "phase" is adapted for its nodes, by the sensor of s alone.
Field adapt_loop(const Field& start, const AdaptOptions& options, Report& report);

}  // namespace quadrille::adapt
