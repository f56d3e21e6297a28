#pragma once
// The stage padapt: adapts the polynomial order of each element of a field, in each region.

#include "adapt/order_policy.hpp"
#include "base/options.hpp"
#include "base/run.hpp"
#include "model/field.hpp"
#include "stage/stage_input.hpp"

namespace quadrille::stage {

struct PadaptOptions : adapt::AdaptOptions {};
void declare(Options& options, PadaptOptions& padapt);

/// The adapted field (adapt/adapt_loop.hpp), harmonic or for prescribed nodes. Reports the numbers of elements of each
/// order. Throws FormatError if `start` breaks a rule of its format, UsageError for options outside their intervals.
Field padapt(const Input<Field>& start, const PadaptOptions& options, Run& run);

}  // namespace quadrille::stage
