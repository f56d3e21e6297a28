#include "trace/trace_separatrices.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "trace/advance.hpp"
#include "trace/build_graph.hpp"
#include "trace/crossings.hpp"
#include "trace/finish_lines.hpp"
#include "trace/launch_all.hpp"
#include "trace/merge_plan.hpp"
#include "trace/planar_faces.hpp"

namespace quadrille {
namespace {

// Shares of the diameter.
constexpr double hit_share = 1e-7;   // as near to a node as this a line ends in it
constexpr double fit_share = 2e-9;   // splines follow their lines within this
constexpr double snap_share = 1e-9;  // nodes nearer than this are one

// Lines that meet head on within this angle (radians) are one, whatever the options say.
constexpr double same_angle = 1e-4;

std::vector<Streamline> trace_all(const FieldEvaluator& evaluator, const CriticalPoints& points,
                                  const std::vector<Vec2>& nodes, const TraceOptions& options) {
  const CadFace& face = evaluator.field().mesh.face;
  const double d = face.diameter;
  const AdvanceOptions bounds{options.tolerance * d, options.step > 0 ? options.step : d / 20, options.max_length * d,
                              hit_share * d};
  std::vector<Launch> launches = launch_all(evaluator, points);
  if (launches.empty() && face.num_loops() == 2) launches = launch_cuts(evaluator);
  std::vector<Streamline> lines;
  lines.reserve(launches.size());
  for (const Launch& launch : launches) lines.push_back(advance(evaluator, launch, nodes, bounds));
  return lines;
}

bool ends_at(const Nurbs& spline, Vec2 x, double near) {
  return distance(spline.poles.front(), x) <= near || distance(spline.poles.back(), x) <= near;
}

// Lines of one family never cross, unless a merge has bent one across the other: that merge is given up.
bool give_up_crossed_merges(const std::vector<Crossing>& crossings, const LineFinisher& lines, double snap,
                            MergePlan& plan) {
  std::vector<int> crossed;
  for (const Crossing& c : crossings) {
    const auto& splines = lines.splines();
    if (c.angle > pi / 4 || (ends_at(splines[c.a], c.position, snap) && ends_at(splines[c.b], c.position, snap)))
      continue;
    for (const int line : {c.a, c.b})
      if (lines.merge_of()[line] >= 0) crossed.push_back(lines.merge_of()[line]);
  }
  return plan.give_up_worst(crossed, 0);
}

void require_few_arcs(const SeparatrixGraph& graph, int max_lines) {
  const auto count =
      std::count_if(graph.arcs.begin(), graph.arcs.end(), [](const GraphArc& arc) { return !arc.is_boundary; });
  if (count > max_lines)
    throw ComputeError(fmt::format("{} separatrices cut each other into {} arcs, more than the {} allowed",
                                   graph.lines.size(), count, max_lines));
}

double largest_turn(const MergePlan& plan, const std::vector<int>& chosen) {
  double turn = 0;
  for (const int c : chosen) turn = std::max(turn, plan.candidate(c).turn);
  return turn;
}

}  // namespace

void TraceOptions::validate() const {
  if (!(tolerance > 0)) throw UsageError("the tolerance must be positive");
  if (step < 0 || merge_distance < 0 || merge_angle < 0) throw UsageError("lengths and angles must not be negative");
  if (max_lines < 1 || !(max_length > 0)) throw UsageError("the bounds must be positive");
}

SeparatrixGraph trace_separatrices(const FieldEvaluator& evaluator, const CriticalPoints& points,
                                   const TraceOptions& options, Report& report) {
  options.validate();
  const CadFace& face = evaluator.field().mesh.face;
  const double snap = snap_share * face.diameter;
  const std::vector<FixedNode> fixed = fixed_nodes(face, points);
  std::vector<Vec2> nodes;
  nodes.reserve(fixed.size());
  for (const FixedNode& node : fixed) nodes.push_back(node.position);
  const std::vector<Streamline> lines = trace_all(evaluator, points, nodes, options);
  report.set("trace.launched", lines.size());

  const double merge_angle = std::max(radians(options.merge_angle), same_angle);
  MergePlan plan(evaluator, lines, nodes, {merge_angle, options.merge_distance});
  LineFinisher finisher(evaluator, lines, fit_share * face.diameter);
  SeparatrixGraph graph;
  std::vector<int> chosen;
  // A merge may turn the layout into something that is none (aggressive ones do): it is given up, the worst first.
  do {
    std::vector<Crossing> crossings;
    do {
      chosen = plan.choose();
      finisher.finish(plan, chosen);
      crossings = find_crossings(finisher.splines(), snap);
    } while (give_up_crossed_merges(crossings, finisher, 2 * snap, plan));
    graph = build_graph(face, fixed, finisher.finished(), crossings, snap);
    require_few_arcs(graph, options.max_lines);
  } while (!cycles_without_four_corners(planar_faces(graph)).empty() && plan.give_up_worst(chosen, same_angle));
  report.set("trace.merged", chosen.size());
  report.set("trace.largest_merge_turn_degrees", degrees(largest_turn(plan, chosen)));

  report.set("trace.lines", graph.lines.size());
  report.set("trace.nodes", graph.nodes.size());
  report.set("trace.arcs", graph.arcs.size());
  report.set("trace.faces", require_four_corners(graph));
  return graph;
}

}  // namespace quadrille
