#include "layout/trace_separatrices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "graph/build_graph.hpp"
#include "graph/crossings.hpp"
#include "graph/family_order.hpp"
#include "graph/planar_faces.hpp"
#include "simplify/simplify.hpp"
#include "trace/advance.hpp"
#include "trace/finish_lines.hpp"
#include "trace/launch_all.hpp"
#include "trace/merge_plan.hpp"
#include "trace/trace_lines.hpp"

namespace quadrille::layout {
namespace {

// Shares of the diameter.
constexpr double fit_share = 2e-9;   // splines follow their lines within this
constexpr double snap_share = 1e-9;  // nodes nearer than this are one

// Diameters to which lines are followed in turn, until what is known of them says enough.
constexpr double reaches[] = {1, 4, std::numeric_limits<double>::infinity()};

// Lines that meet head on within this angle (radians) are one, whatever the options say.
constexpr double same_angle = 1e-4;

bool ends_at(const Nurbs& spline, Vec2 x, double near) {
  return distance(spline.poles.front(), x) <= near || distance(spline.poles.back(), x) <= near;
}

// Lines of one family never cross, unless a merge has bent one across the other: that merge is given up.
bool give_up_crossed_merges(const std::vector<graph::Crossing>& crossings, const trace::LineFinisher& lines,
                            double snap, Vec2 origin, trace::MergePlan& plan) {
  std::vector<int> crossed;
  std::vector<graph::Crossing> of_one_family;
  std::vector<bool> is_merged;
  for (const int merge : lines.merge_of()) is_merged.push_back(merge >= 0);
  for (const graph::Crossing& c : crossings) {
    const auto& splines = lines.splines();
    if (!graph::is_of_one_family(c) ||
        (ends_at(splines[c.a], c.position, snap) && ends_at(splines[c.b], c.position, snap)))
      continue;
    of_one_family.push_back(c);
    for (const int line : {c.a, c.b})
      if (is_merged[line]) crossed.push_back(lines.merge_of()[line]);
  }
  if (plan.give_up_worst(crossed, 0)) return true;
  graph::require_family_order(of_one_family, is_merged, origin);
  return false;
}

void require_few_arcs(const SeparatrixGraph& graph, int max_lines) {
  const auto count =
      std::count_if(graph.arcs.begin(), graph.arcs.end(), [](const GraphArc& arc) { return !arc.is_boundary; });
  if (count > max_lines)
    throw ComputeError(fmt::format("{} separatrices cut each other into {} arcs, more than the {} allowed",
                                   graph.lines.size(), count, max_lines));
}

double largest_turn(const trace::MergePlan& plan, const std::vector<int>& chosen) {
  double turn = 0;
  for (const int c : chosen) turn = std::max(turn, plan.candidate(c).turn);
  return turn;
}

struct Partition {
  SeparatrixGraph graph;
  size_t num_merged = 0;
  double largest_turn = 0;
};

// The graph of the lines as far as they have been followed; nothing where that says too little.
std::optional<Partition> partition(const field::FieldEvaluator& evaluator, const std::vector<graph::FixedNode>& fixed,
                                   const std::vector<Vec2>& nodes, const trace::LineTracer& tracer,
                                   const LayoutOptions& options) {
  const CadFace& face = evaluator.field().mesh.face;
  const double snap = snap_share * face.diameter,
               merge_angle = std::max(radians(options.trace.merge_angle), same_angle);
  const std::vector<trace::Streamline>& lines = tracer.lines();
  trace::MergePlan plan(evaluator, lines, nodes, {merge_angle, options.trace.merge_distance}, tracer.reach());
  trace::LineFinisher finisher(evaluator, lines, fit_share * face.diameter);
  SeparatrixGraph graph;
  std::vector<int> chosen;
  // A merge may turn the layout into something that is none (aggressive ones do): it is given up, the worst first.
  do {
    std::vector<graph::Crossing> crossings;
    do {
      chosen = plan.choose();
      if (plan.is_cut_short()) return std::nullopt;
      finisher.finish(plan, chosen);
      crossings = graph::find_crossings(finisher.splines(), snap, {.origin = face.origin, .sought = {}});
    } while (give_up_crossed_merges(crossings, finisher, 2 * snap, face.origin, plan));
    graph = graph::build_graph(face, fixed, finisher.finished(), crossings, snap);
    require_few_arcs(graph, options.max_lines);
  } while (!graph::cycles_without_four_corners(graph::planar_faces(graph)).empty() &&
           plan.give_up_worst(chosen, same_angle));
  return Partition{std::move(graph), chosen.size(), largest_turn(plan, chosen)};
}

}  // namespace

SeparatrixGraph trace_separatrices(const field::FieldEvaluator& evaluator, const CriticalPoints& points,
                                   const LayoutOptions& options, Report& report) {
  options.validate();
  const CadFace& face = evaluator.field().mesh.face;
  const std::vector<graph::FixedNode> fixed = trace::fixed_nodes(face, points);
  std::vector<Vec2> nodes;
  nodes.reserve(fixed.size());
  for (const graph::FixedNode& node : fixed) nodes.push_back(node.position);
  trace::LineTracer tracer(evaluator, points, nodes, options.trace);
  std::optional<Partition> found;
  for (const double reach : reaches) {
    tracer.follow_to(reach * face.diameter);
    found = partition(evaluator, fixed, nodes, tracer, options);
    if (found) break;
  }
  SeparatrixGraph graph = std::move(found->graph);
  report.set("trace.launched", tracer.lines().size());
  report.set("trace.merged", found->num_merged);
  report.set("trace.largest_merge_turn_degrees", degrees(found->largest_turn));
  graph.certificate.merged_lines = static_cast<int>(found->num_merged);
  graph.certificate.largest_deviation_degrees = degrees(found->largest_turn);

  if (options.simplify != "none") {
    graph::require_four_corners(graph);
    graph = simplify::simplify(evaluator, std::move(graph), simplify_options(options), report);
  }
  report.set("trace.lines", graph.lines.size());
  report.set("trace.nodes", graph.nodes.size());
  report.set("trace.arcs", graph.arcs.size());
  report.set("trace.faces", graph::require_four_corners(graph));
  return graph;
}

}  // namespace quadrille::layout
