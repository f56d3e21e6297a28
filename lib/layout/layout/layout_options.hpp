#pragma once
// The options of the computation of a layout from a field.

#include <array>

#include "base/enum_names.hpp"
#include "layout/layout_choice.hpp"
#include "midpoint/midpoint_graph.hpp"
#include "simplify/simplify.hpp"
#include "trace/trace_options.hpp"

namespace quadrille::layout {

/// Collapse of chords (simplify/simplify.hpp).
enum class SimplifyLevel {
  none,
  normal,   ///< if it saves more blocks than it costs in block quality
  coarsest  ///< if block quality stays acceptable
};

constexpr auto enum_names(SimplifyLevel) { return std::to_array({"none", "normal", "coarsest"}); }

struct LayoutOptions {
  trace::TraceOptions trace;
  SimplifyLevel simplify = SimplifyLevel::normal;
  double max_deviation = 40;  ///< degrees: of a simplified line from the field; `coarsest` allows 45 at least
  int max_lines = 2000;       ///< more arcs of separatrices than this is an error
  LayoutChoice layout = LayoutChoice::automatic;
  midpoint::CoarseMesher coarse_mesher = {};  ///< for midpoint division; without it, `automatic` has no such layout
  void validate() const;                      ///< throws UsageError
};

/// The bounds that result from options.simplify and options.max_deviation.
simplify::SimplifyOptions simplify_options(const LayoutOptions& options);

}  // namespace quadrille::layout
