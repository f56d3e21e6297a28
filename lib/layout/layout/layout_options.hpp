#pragma once
// The options of the computation of a layout from a field.

#include <array>
#include <functional>
#include <vector>

#include "base/enum_names.hpp"
#include "base/report.hpp"
#include "layout/layout_choice.hpp"
#include "model/tri_mesh.hpp"
#include "simplify/simplify.hpp"
#include "trace/line_tracer.hpp"

namespace quadrille::layout {

/// Collapse of chords (simplify/simplify.hpp).
enum class SimplifyLevel {
  none,
  normal,   ///< if it saves more blocks than it costs in block quality
  coarsest  ///< if block quality stays acceptable
};

constexpr auto enum_names(SimplifyLevel) { return std::to_array({"none", "normal", "coarsest"}); }

/// Makes coarse triangles of a face (triangulate/triangulate.hpp), and refines those that the second function
/// names; in a face of several regions they have the same edges on both sides of interfaces. Throws ComputeError if
/// there are none. A function is handed on, so that who does not divide triangles need not be linked with CGAL.
using CoarseMesher =
    std::function<TriMesh(const CadFace&, const std::function<std::vector<int>(const TriMesh&)>&, Report&)>;

struct LayoutOptions {
  trace::TraceOptions trace;
  SimplifyLevel simplify = SimplifyLevel::normal;
  double max_deviation = 40;  ///< degrees: of a simplified line from the field; `coarsest` allows 45 at least
  int max_lines = 2000;       ///< more arcs of separatrices than this is an error
  LayoutChoice layout = LayoutChoice::automatic;
  CoarseMesher coarse_mesher = {};  ///< for midpoint division; without it, `automatic` has no such layout
  void validate() const;            ///< throws UsageError
};

/// The bounds that result from options.simplify and options.max_deviation.
simplify::SimplifyOptions simplify_options(const LayoutOptions& options);

}  // namespace quadrille::layout
