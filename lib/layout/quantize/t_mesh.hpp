#pragma once
// The T-mesh of a guiding field: separatrices, each up to the first line that crosses it and reached the crossing
// before (quantize/motorcycle_graph.hpp). It is finite for every field, spirals and limit cycles included, and all its
// faces have four corners: one quarter turn of the cross each, at crossings and line ends; T-junctions lie on their
// sides.

#include <vector>

#include "base/report.hpp"
#include "field/evaluate.hpp"
#include "graph/candidate_layout.hpp"
#include "model/critical_points.hpp"
#include "model/separatrix_graph.hpp"
#include "quantize/motorcycle_graph.hpp"
#include "trace/line_tracer.hpp"
#include "trace/merged_lines.hpp"

namespace quadrille::quantize {

/// Start of an auxiliary line (a cut), on the boundary.
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

/// Head-on separatrices are merged as in layout/trace_separatrices, then all fronts start together. Cuts are added for
/// holes and limit cycles that meet no line. Lines are traced no farther than needed: from two
/// diameters on, or a fraction of one where there are more than 500, the greatest length of lines that are not stopped
/// is doubled.
class TMeshTracer {
 public:
  /// `evaluator` must outlive the tracer. Throws ComputeError as trace::launch_all and trace::advance.
  TMeshTracer(const field::FieldEvaluator& evaluator, const CriticalPoints& points, const trace::TraceOptions& options,
              Progress* progress = nullptr);
  TMeshTracer(const TMeshTracer&) = delete;  // its members refer to each other
  TMeshTracer& operator=(const TMeshTracer&) = delete;

  /// The T-mesh, with merged_lines and the largest deviation of its certificate. Reports t_mesh.*. Throws ComputeError
  /// if a line cannot be traced, if one that no other stops needs too many steps, or if 100 cuts are not enough.
  graph::CandidateLayout trace(Report& report);

  /// Rejects for each strip, given by its arcs, among the merges of lines with one of these (`lines`: of the T-mesh
  /// traced last), those whose deviation is within 1e-6 of the largest; if no strip has any, among all merges. Two
  /// merges may contradict each other: one puts two nodes on one line of the integer grid, the other does not. Returns
  /// false if no merge remains to be rejected.
  bool reject_merges(const std::vector<SeparatrixLine>& lines, const std::vector<std::vector<int>>& strips);

 private:
  bool follow_unstopped_lines(const std::vector<CoveredPart>& covered);
  bool connect_loops(const SeparatrixGraph& graph);
  void add_cut(const CutStart& start, double head_start);

  struct Cuts {
    std::vector<double> head_starts;  ///< of all streamlines, lengths; 0 except for cuts across limit cycles
    std::vector<int> num_of_loop;
    int num = 0;
  };
  const field::FieldEvaluator& evaluator_;
  std::vector<GraphNode> fixed_;
  std::vector<Vec2> nodes_;  // their positions
  trace::LineTracer tracer_;
  trace::MergedLines lines_;
  Cuts cuts_;
  std::vector<int> piece2line_;  // of the graph traced last
};

}  // namespace quadrille::quantize
