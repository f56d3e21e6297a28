#include "refine/refine_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/enum_names.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"

namespace quadrille::refine {

void RefineOptions::validate() const {
  if (!(size >= 0)) throw UsageError("--size must not be negative");
  if (order < 1 || order > 20) throw UsageError("--order must lie in 1..20");
  if (!(min_scaled_jacobian >= 0 && min_scaled_jacobian <= 1))
    throw UsageError("--min-scaled-jacobian must lie in 0..1");
  if (!(target_edge_ratio == 0 || target_edge_ratio >= 1))
    throw UsageError("--target-edge-ratio must be 0 or at least 1");
  if (!(target_growth == 0 || target_growth > 1)) throw UsageError("--target-growth must be 0 or greater than 1");
  if (!(max_edge_ratio == 0 || max_edge_ratio >= 1)) throw UsageError("--max-edge-ratio must be 0 or at least 1");
  if (levels < 0 || levels > 10) throw UsageError("--refine must lie in 0..10");
  if (relax_sweeps < 0 || relax_sweeps > 1000) throw UsageError("--relax-sweeps must lie in 0..1000");
  if (max_elements < 1) throw UsageError("--max-elements must be at least 1");
  if (!(geometry_tol >= 0)) throw UsageError("--geometry-tol must not be negative");
  const auto even = std::ranges::find_if(boundary_counts, &prescribe::BoundaryCount::is_even);
  if (even == boundary_counts.end()) return;
  const std::string count = fmt::format("--count {}={},even", even->boundary, even->count);
  if (relax == Relax::none || relax_sweeps == 0)
    throw UsageError(count + ": vertices have to move for elements of equal length: leave out --relax none");
  if (!blocks.empty()) throw UsageError(count + " and --blocks exclude each other: with --blocks no vertex moves");
}

Relax parse_relax(const std::string& text) {
  if (const std::optional<Relax> goal = enum_value<Relax>(text)) return *goal;
  if (number_of<int>(text)) throw UsageError(fmt::format("--relax {0} is now --relax shape --relax-sweeps {0}", text));
  throw UsageError(fmt::format("--relax: '{}' is not one of {}", text, fmt::join(all_enum_names<Relax>(), ", ")));
}

double default_geometry_tol(int order) { return order == 1 ? 5e-3 : order == 2 ? 5e-4 : order == 3 ? 2e-5 : 5e-7; }

}  // namespace quadrille::refine
