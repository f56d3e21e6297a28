#pragma once
// Auxiliary lines from the boundary (cuts) that a T-mesh needs: across limit cycles that cross no other line, and from
// holes that no line connects to the outer boundary.

#include <vector>

#include "model/separatrix_graph.hpp"
#include "trace/line_tracer.hpp"

namespace quadrille::quantize {

struct CutStart {
  int curve = 0;  ///< CAD curve
  double t = 0;   ///< its parameter
};

/// Start of a cut across the end of a limit cycle: the end of the first line that runs from there across the cycle, to
/// its left or right, to the boundary. Throws ComputeError with the position if neither line reaches it.
CutStart cut_across_limit_cycle(const field::FieldEvaluator& evaluator, const trace::LineTracer& tracer,
                                const trace::Streamline& line);

/// The loops, ascending, that no path along arcs of the graph connects to the outer boundary (loop 0).
std::vector<int> unconnected_loops(const SeparatrixGraph& graph);

/// Start of the k-th cut (k = 0, 1, ...) of a loop. Holes may be connected to each other only, so each cut starts at
/// another point, at the middle of the first curve, then at halves, quarters, eighths of the loop's curves in turn (van
/// der Corput's sequence).
CutStart cut_from_loop(const CadFace& face, int loop, int k);

}  // namespace quadrille::quantize
