#pragma once
// Everything that a user can choose about the way from a field to a layout.

#include <string>

#include "simplify/simplify.hpp"
#include "trace/trace_options.hpp"

namespace quadrille::layout {

struct LayoutOptions {
  trace::TraceOptions trace;
  std::string simplify = "normal";  ///< collapse of chords: "none", "normal", "coarsest"
  double max_turn = 40;             ///< degrees: of a line from the field, by that; `coarsest` allows 45 at least
  int max_lines = 2000;             ///< more arcs of separatrices than this is an error
  /// "traced", "quantized", "auto" or "t-mesh" (layout/compute_layout.hpp).
  std::string layout = "auto";
  void validate() const;  ///< throws UsageError
};

/// What options.simplify stands for.
simplify::SimplifyOptions simplify_options(const LayoutOptions& options);

}  // namespace quadrille::layout
