#include "layout/trace_separatrices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/tolerance.hpp"
#include "curve/face_boundary.hpp"
#include "graph/build_graph.hpp"
#include "graph/candidate_layout.hpp"
#include "simplify/line_ends.hpp"
#include "simplify/simplify.hpp"
#include "trace/launch.hpp"
#include "trace/line_tracer.hpp"
#include "trace/merged_lines.hpp"

namespace quadrille::layout {
namespace {

bool is_move_from_fillet(const NodeChange& change) {
  const auto is_inner = [](const std::vector<NodeMark>& nodes) {
    return nodes.size() == 1 && nodes[0].valence == 3 && nodes[0].location == NodeLocation::inside;
  };
  return change.kind == ChangeKind::feature && is_inner(change.before) && is_inner(change.after);
}

// Lines are traced to this length, in diameters; those whose merge is not decided then so many times as far, again and
// again.
constexpr double first_reach = 1, longer = 4;

void continue_lines(const std::set<int>& lines, trace::LineTracer& tracer, Progress* progress) {
  const Progress::Part part(progress, "lines", std::ssize(lines));
  const std::vector<double> reaches = tracer.reaches();
  for (const int line : lines) {
    tracer.follow_to(line, longer * reaches[line]);
    part.advance();
  }
}

// Every crossing ends two arcs, but lines that meet at a node are counted as crossings too.
constexpr std::size_t max_crossings_per_arc = 10;

void require_few_arcs(const SeparatrixGraph& graph, int max_lines) {
  const auto count =
      std::count_if(graph.arcs.begin(), graph.arcs.end(), [](const GraphArc& arc) { return !arc.is_boundary; });
  if (count > max_lines)
    throw graph::CrowdedLinesError(fmt::format("{} separatrices cut each other into {} arcs, more than the {} allowed",
                                               graph.lines.size(), count, max_lines));
}

void require_total_length(const trace::LineTracer& tracer, double diameter, double most) {
  double total = 0;
  for (const trace::Streamline& line : tracer.lines()) total += line.length() / diameter;
  if (total > most)
    throw ComputeError(fmt::format("{} separatrices are {:.3g} diameters long together, more than the {:g} allowed",
                                   tracer.lines().size(), total, most));
}

// The graph of the lines traced so far, with its merged lines and their largest deviation, or the lines that must be
// continued.
struct Partition {
  std::optional<graph::CandidateLayout> layout;
  std::set<int> unsettled;
};

Partition partition(const field::FieldEvaluator& evaluator, const std::vector<GraphNode>& fixed,
                    const std::vector<Vec2>& nodes, const trace::LineTracer& tracer, const LayoutOptions& options,
                    Progress* progress) {
  const CadFace& face = evaluator.field().mesh.face;
  trace::MergedLines lines(evaluator, tracer.lines(), nodes, radians(options.trace.merge_angle),
                           options.trace.merge_distance, trace::LineEnds::required,
                           {tracer.reaches(), max_crossings_per_arc * options.max_lines});
  graph::CandidateLayout layout;
  // An aggressive merge may result in a face without four corners: such merges are rejected, the worst first.
  do {
    if (!lines.merge(progress)) return {std::nullopt, lines.unsettled()};
    std::vector<graph::FinishedLine> finished;
    for (const trace::MergedLine& line : lines.arrangement().lines) finished.push_back(line.line);
    SeparatrixGraph graph = graph::build_graph(face, fixed, std::move(finished), lines.arrangement().crossings,
                                               tolerance::round_off * face.diameter);
    require_few_arcs(graph, options.max_lines);
    layout = graph::candidate_layout(std::move(graph), layout.num_built);
  } while (!graph::faces_without_four_corners(layout.subdivision).empty() &&
           lines.reject_worst(lines.chosen(), trace::same_line_angle));
  layout.certificate.merged_lines = static_cast<int>(lines.chosen().size());
  layout.certificate.largest_deviation_degrees = degrees(lines.largest_deviation());
  return {std::move(layout), {}};
}

// Ends lines of the layout on the small fillets whose nodes critpoints moved inward (simplify/line_ends.hpp), where
// that makes better blocks: a node of valence 3 that moved because of a feature was beside the middle of its fillet.
void end_lines_on_fillets(const field::FieldEvaluator& evaluator, const CriticalPoints& points,
                          graph::CandidateLayout& layout, Report& report) {
  if (std::none_of(points.changes.begin(), points.changes.end(), is_move_from_fillet)) return;
  std::vector<simplify::FilletMiddle> fillets;
  const curve::FaceBoundary boundary(layout.graph().face);
  for (const NodeChange& change : points.changes) {
    if (!is_move_from_fillet(change)) continue;
    const curve::NearestPoint middle = boundary.nearest(change.before[0].position);
    fillets.push_back({middle.curve, middle.t});
  }
  const simplify::FilletEnds ends = simplify::end_lines_on_fillets(evaluator, fillets, layout);
  report.set("fillets.lines_moved", ends.num_moved);
  double& deviation = layout.certificate.largest_deviation_degrees;
  deviation = std::max(deviation, degrees(ends.deviation));
}

}  // namespace

graph::CandidateLayout trace_separatrices(const field::FieldEvaluator& evaluator, const CriticalPoints& points,
                                          const LayoutOptions& options, Report& report) {
  options.validate();
  const CadFace& face = evaluator.field().mesh.face;
  const std::vector<GraphNode> fixed = trace::fixed_nodes(face, points);
  const std::vector<Vec2> nodes = trace::positions(fixed);
  trace::LineTracer tracer(evaluator, points, nodes, options.trace);
  Partition found;
  const Progress::Part round(report.progress(), "round");
  tracer.follow_all_to(first_reach * face.diameter, report.progress());
  for (;; continue_lines(found.unsettled, tracer, report.progress())) {
    round.advance();
    report.set("trace.steps", tracer.num_steps());
    require_total_length(tracer, face.diameter, options.trace.max_total_length);
    const Progress::Part part(report.progress(), "crossings and merges");
    found = partition(evaluator, fixed, nodes, tracer, options, report.progress());
    if (found.layout) break;
  }
  graph::CandidateLayout layout = std::move(*found.layout);
  report.set("trace.launched", tracer.lines().size());
  report.set("trace.merged", layout.certificate.merged_lines);
  report.set("trace.largest_merge_deviation_degrees", layout.certificate.largest_deviation_degrees);
  graph::require_four_corners(layout.subdivision);
  end_lines_on_fillets(evaluator, points, layout, report);
  if (options.simplify != SimplifyLevel::none)
    layout = simplify::simplify(evaluator, std::move(layout), simplify_options(options), report);
  report.set("trace.lines", layout.lines.size());
  report.set("trace.nodes", layout.graph().nodes.size());
  report.set("trace.arcs", layout.graph().arcs.size());
  report.set("trace.faces", graph::require_four_corners(layout.subdivision));
  return layout;
}

}  // namespace quadrille::layout
