#include "trace/trace_separatrices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "trace/advance.hpp"
#include "trace/build_graph.hpp"
#include "trace/crossings.hpp"
#include "trace/family_order.hpp"
#include "trace/finish_lines.hpp"
#include "trace/launch_all.hpp"
#include "trace/merge_plan.hpp"
#include "trace/planar_faces.hpp"
#include "trace/simplify.hpp"
#include "trace/trace_lines.hpp"

namespace quadrille {
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
bool give_up_crossed_merges(const std::vector<Crossing>& crossings, const LineFinisher& lines, double snap, Vec2 origin,
                            MergePlan& plan) {
  std::vector<int> crossed;
  std::vector<Crossing> of_one_family;
  std::vector<bool> is_merged;
  for (const int merge : lines.merge_of()) is_merged.push_back(merge >= 0);
  for (const Crossing& c : crossings) {
    const auto& splines = lines.splines();
    if (!is_of_one_family(c) || (ends_at(splines[c.a], c.position, snap) && ends_at(splines[c.b], c.position, snap)))
      continue;
    of_one_family.push_back(c);
    for (const int line : {c.a, c.b})
      if (is_merged[line]) crossed.push_back(lines.merge_of()[line]);
  }
  if (plan.give_up_worst(crossed, 0)) return true;
  require_family_order(of_one_family, is_merged, origin);
  return false;
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

struct Partition {
  SeparatrixGraph graph;
  size_t num_merged = 0;
  double largest_turn = 0;
};

// The graph of the lines as far as they have been followed; nothing where that says too little.
std::optional<Partition> partition(const FieldEvaluator& evaluator, const std::vector<FixedNode>& fixed,
                                   const std::vector<Vec2>& nodes, const LineTracer& tracer,
                                   const TraceOptions& options) {
  const CadFace& face = evaluator.field().mesh.face;
  const double snap = snap_share * face.diameter, merge_angle = std::max(radians(options.merge_angle), same_angle);
  const std::vector<Streamline>& lines = tracer.lines();
  MergePlan plan(evaluator, lines, nodes, {merge_angle, options.merge_distance}, tracer.reach());
  LineFinisher finisher(evaluator, lines, fit_share * face.diameter);
  SeparatrixGraph graph;
  std::vector<int> chosen;
  // A merge may turn the layout into something that is none (aggressive ones do): it is given up, the worst first.
  do {
    std::vector<Crossing> crossings;
    do {
      chosen = plan.choose();
      if (plan.is_cut_short()) return std::nullopt;
      finisher.finish(plan, chosen);
      crossings = find_crossings(finisher.splines(), snap, {.origin = face.origin, .sought = {}});
    } while (give_up_crossed_merges(crossings, finisher, 2 * snap, face.origin, plan));
    graph = build_graph(face, fixed, finisher.finished(), crossings, snap);
    require_few_arcs(graph, options.max_lines);
  } while (!cycles_without_four_corners(planar_faces(graph)).empty() && plan.give_up_worst(chosen, same_angle));
  return Partition{std::move(graph), chosen.size(), largest_turn(plan, chosen)};
}

// Degrees that the coarsest layout may turn its lines away from the field, whatever the options say.
constexpr double coarsest_turn = 45;

}  // namespace

void TraceOptions::validate() const {
  if (!(tolerance > 0)) throw UsageError("the tolerance must be positive");
  if (step < 0 || merge_distance < 0 || merge_angle < 0) throw UsageError("lengths and angles must not be negative");
  if (max_turn < 0) throw UsageError("the greatest turn must not be negative");
  if (max_lines < 1 || !(max_length > 0)) throw UsageError("the bounds must be positive");
}

SimplifyOptions simplify_options(const TraceOptions& options) {
  SimplifyOptions simplify;
  simplify.is_thrifty = options.simplify != "coarsest";
  simplify.least_scaled_jacobian = simplify.is_thrifty ? 0.5 : 0.3;
  simplify.max_turn =
      radians(options.simplify == "coarsest" ? std::max(options.max_turn, coarsest_turn) : options.max_turn);
  return simplify;
}

SeparatrixGraph trace_separatrices(const FieldEvaluator& evaluator, const CriticalPoints& points,
                                   const TraceOptions& options, Report& report) {
  options.validate();
  const CadFace& face = evaluator.field().mesh.face;
  const std::vector<FixedNode> fixed = fixed_nodes(face, points);
  std::vector<Vec2> nodes;
  nodes.reserve(fixed.size());
  for (const FixedNode& node : fixed) nodes.push_back(node.position);
  LineTracer tracer(evaluator, points, nodes, options);
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
  graph.certificate.largest_turn_degrees = degrees(found->largest_turn);

  if (options.simplify != "none") {
    require_four_corners(graph);
    graph = simplify(evaluator, std::move(graph), simplify_options(options), report);
  }
  report.set("trace.lines", graph.lines.size());
  report.set("trace.nodes", graph.nodes.size());
  report.set("trace.arcs", graph.arcs.size());
  report.set("trace.faces", require_four_corners(graph));
  return graph;
}

}  // namespace quadrille
