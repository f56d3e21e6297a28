#include "layout/quantized_layout.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/tolerance.hpp"
#include "curve/nurbs.hpp"
#include "guide/valence.hpp"
#include "quantize/quantize_and_extend.hpp"
#include "quantize/t_mesh.hpp"
#include "simplify/simplify.hpp"
#include "surface/positions.hpp"

namespace quadrille::layout {
namespace {

constexpr std::size_t max_corner_valences = 4;

struct Strip {
  std::vector<Corner> corners;  // by ascending joint
  std::vector<CriticalPoint> nodes;
};

Strip strip_of(const ArcGraph& t_mesh, const std::vector<int>& arcs, const CriticalPoints& points) {
  Strip strip;
  std::set<int> ends, joints;
  for (const int a : arcs) ends.insert({t_mesh.arcs[a].from, t_mesh.arcs[a].to});
  for (const int n : ends) {
    const GraphNode& node = t_mesh.nodes[n];
    if (node.kind == NodeKind::corner) joints.insert(node.curve);  // the outgoing curve has the number of its joint
    if (node.kind != NodeKind::irregular) continue;
    for (const CriticalPoint& p : points.critical_points)
      if (p.position == node.position) strip.nodes.push_back(p);
  }
  for (const Corner& c : points.corners)
    if (joints.count(c.joint) > 0) strip.corners.push_back(c);
  return strip;
}

bool has_change(const CriticalPoints& points, ChangeKind kind, const std::vector<Corner>& corners) {
  const auto concerns = [&](const NodeMark& mark) {
    return mark.location == NodeLocation::corner &&
           std::any_of(corners.begin(), corners.end(), [&](const Corner& c) { return c.position == mark.position; });
  };
  return std::any_of(points.changes.begin(), points.changes.end(), [&](const NodeChange& change) {
    return change.kind == kind && std::any_of(change.after.begin(), change.after.end(), concerns);
  });
}

// Nodes that were placed or that critpoints never moves stay where they are.
bool may_move(const CriticalPoint& node) {
  return node.source != NodeSource::divide && node.source != NodeSource::place;
}

struct CornerChange {
  std::string option;
  double added_defect = 0;
};

std::vector<CornerChange> corner_changes(const std::vector<Corner>& corners) {
  std::vector<CornerChange> changes;
  for (const Corner& c : corners) {
    const int valence = c.angle_degrees > 180 ? c.valence - 1 : c.valence + 1;
    if (valence < 1 || !guide::is_admissible_valence(c.angle_degrees, valence)) continue;
    const double angle = radians(c.angle_degrees), now = c.valence > 0 ? guide::angle_defect(angle, c.valence) : 0;
    changes.push_back({fmt::format("--corner-valence {}:{}={}", c.curves[0], c.curves[1], valence),
                       guide::angle_defect(angle, valence) - now});
  }
  std::stable_sort(changes.begin(), changes.end(), [](const CornerChange& a, const CornerChange& b) {
    return std::round(a.added_defect / tolerance::tied) < std::round(b.added_defect / tolerance::tied);
  });
  if (changes.size() > max_corner_valences) changes.resize(max_corner_valences);
  return changes;
}

[[noreturn]] void fail_to_quantize(const quantize::InfeasibleTMesh& failed, const CriticalPoints& points,
                                   Report& report) {
  const std::vector<int> zero_arcs = failed.zero_arcs();
  if (failed.strips.empty() || zero_arcs.empty())
    throw ComputeError("no integer lengths were found for the arcs of the T-mesh");
  const ArcGraph& t_mesh = failed.t_mesh.graph();
  const std::vector<std::string> remedies = strip_remedies(t_mesh, failed.strips.front(), points);
  report.set("quantize.remedies", fmt::format("{}", fmt::join(remedies, ", ")));
  const ArcPiece& piece = t_mesh.arcs[zero_arcs.front()].pieces.front();
  const Vec2 position = curve::point(t_mesh.curve(piece.curve), (piece.t0 + piece.t1) / 2);
  throw ComputeError(fmt::format(
      "no whole numbers of elements fit this field: a strip of blocks winds onto itself, and {} arcs of the T-mesh "
      "have length 0 in every solution, the first at {}",
      zero_arcs.size(), surface::position_text(t_mesh.face, position)));
}

}  // namespace

std::vector<std::string> strip_remedies(const ArcGraph& t_mesh, const std::vector<int>& strip_arcs,
                                        const CriticalPoints& points) {
  const Strip strip = strip_of(t_mesh, strip_arcs, points);
  std::vector<std::string> remedies;
  if (has_change(points, ChangeKind::absorb, strip.corners)) remedies.emplace_back("--corner-absorb 0");
  if (has_change(points, ChangeKind::line, strip.corners)) remedies.emplace_back("--ties field");
  if (std::any_of(strip.nodes.begin(), strip.nodes.end(), may_move)) remedies.emplace_back("--place energy");
  for (const CornerChange& change : corner_changes(strip.corners)) remedies.push_back(change.option);
  return remedies;
}

graph::CandidateLayout quantized_layout(const field::FieldEvaluator& evaluator, const CriticalPoints& points,
                                        const LayoutOptions& options, Report& report) {
  quantize::TMeshTracer tracer(evaluator, points, options.trace, report.progress());
  int num_rejected = 0;
  const auto without_merges = [&](const quantize::InfeasibleTMesh& failed) {
    if (failed.strips.empty() || !tracer.reject_merges(failed.t_mesh.lines, failed.strips))
      fail_to_quantize(failed, points, report);
    ++num_rejected;
    graph::CandidateLayout t_mesh = tracer.trace(report);
    t_mesh.num_built += failed.t_mesh.num_built;
    return t_mesh;
  };
  quantize::ExtendedTMesh extended = quantize::quantize_and_extend(
      tracer.trace(report), quantize::PeriodicSides::separate, without_merges, report.progress());
  graph::CandidateLayout layout = std::move(extended.layout);
  report.set("quantize.rejected_merges", num_rejected);
  report.set("quantize.longest_arc", extended.longest_arc);
  report.set("quantize.faces", layout.subdivision.num_faces());
  if (options.simplify != SimplifyLevel::none)
    layout = simplify::simplify(evaluator, std::move(layout), simplify_options(options), report);
  return layout;
}

}  // namespace quadrille::layout
