#include "layout/lay_out.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "base/error.hpp"
#include "curve/chain.hpp"
#include "curve/nurbs.hpp"
#include "layout/certificate.hpp"
#include "quantize/extend_lines.hpp"
#include "quantize/quantize.hpp"
#include "quantize/t_mesh.hpp"
#include "quantize/t_mesh_faces.hpp"
#include "simplify/chord_judge.hpp"
#include "trace/fixed_nodes.hpp"
#include "trace/launch_all.hpp"

namespace quadrille::layout {
namespace {

// An arc of this share of the diameter has length one.
constexpr double unit_share = 0.1;

std::vector<double> arc_lengths(const SeparatrixGraph& graph) {
  const curve::CurveTable table(graph.face, graph.splines);
  std::vector<double> lengths;
  for (const GraphArc& arc : graph.arcs) {
    // Lines go by arc length, merged ones nearly so.
    const ArcPiece& piece = arc.pieces.front();
    lengths.push_back(arc.is_boundary ? curve::Chain(table, arc.pieces).length() : std::abs(piece.t1 - piece.t0));
  }
  return lengths;
}

[[noreturn]] void fail_to_quantize(const SeparatrixGraph& t_mesh, const std::vector<int>& zero) {
  if (zero.empty()) throw ComputeError("no whole lengths were found for the arcs of the T-mesh");
  const ArcPiece& piece = t_mesh.arcs[zero.front()].pieces.front();
  const Vec2 place = curve::point(t_mesh.curve(piece.curve), (piece.t0 + piece.t1) / 2) + t_mesh.face.origin;
  throw ComputeError(fmt::format(
      "no whole numbers of elements fit this field: a strip of blocks winds onto itself, and {} arcs of the "
      "T-mesh can have no length but zero, the first at ({:.6g}, {:.6g})",
      zero.size(), place.x, place.y));
}

SeparatrixGraph quantized_layout(const field::FieldEvaluator& evaluator, const CriticalPoints& points,
                                 const LayoutOptions& options, Report& report) {
  quantize::TMeshTracer tracer(evaluator, points, options.trace);
  SeparatrixGraph t_mesh;
  std::vector<quantize::TFace> faces;
  std::vector<int> lengths;
  int given_up = 0;
  for (;; ++given_up) {
    t_mesh = tracer.trace(report);
    faces = quantize::t_mesh_faces(t_mesh);
    lengths = quantize::quantize(faces, arc_lengths(t_mesh), unit_share * t_mesh.face.diameter);
    if (!lengths.empty()) break;
    const int num_arcs = static_cast<int>(t_mesh.arcs.size());
    const std::vector<int> zero = quantize::vanishing_arcs(faces, num_arcs);
    if (zero.empty()) fail_to_quantize(t_mesh, zero);
    if (!tracer.reject_merge(t_mesh, quantize::winding_rails(faces, num_arcs, zero.front())))
      fail_to_quantize(t_mesh, zero);
  }
  report.set("quantize.merges_given_up", given_up);
  report.set("quantize.longest_arc", *std::max_element(lengths.begin(), lengths.end()));
  SeparatrixGraph graph = quantize::extend_lines(t_mesh, faces, lengths);
  report.set("quantize.faces", graph::planar_faces(graph).cycles.size());
  if (options.simplify != "none")
    graph = simplify::simplify(evaluator, std::move(graph), simplify_options(options), report);
  return graph;
}

// Whole lines cut each other into a number of blocks that grows like the square of theirs: more than so many are not
// tried.
constexpr int most_traced_lines = 500;

// Lines that stop at each other make a block each, and as many more as the domain's Euler characteristic. Whole lines
// that make this many times as many are suspected of cutting each other more often than they need.
constexpr double too_many_blocks = 1.2;

bool has_too_many_blocks(const SeparatrixGraph& graph) {
  const auto least = static_cast<double>(graph.lines.size()) + graph.face.euler_characteristic();
  return static_cast<double>(graph::planar_faces(graph).cycles.size()) > too_many_blocks * least;
}

simplify::BlockShape worst_block(const SeparatrixGraph& graph, const graph::PlanarFaces& faces) {
  std::vector<int> all(faces.cycles.size());
  std::iota(all.begin(), all.end(), 0);
  return simplify::worst_shape(graph, faces, all);
}

// The quantized layout where it has fewer blocks, all proved and none worse than the worst of `traced`.
std::optional<SeparatrixGraph> layout_of_fewer_blocks(const field::FieldEvaluator& evaluator,
                                                      const CriticalPoints& points, const LayoutOptions& options,
                                                      const SeparatrixGraph& traced, Report& report) {
  Report attempt;
  std::optional<SeparatrixGraph> found;
  try {
    found = quantized_layout(evaluator, points, options, attempt);
  } catch (const ComputeError&) {
    return std::nullopt;
  }
  const graph::PlanarFaces before = graph::planar_faces(traced), after = graph::planar_faces(*found);
  if (after.cycles.size() >= before.cycles.size()) return std::nullopt;
  const simplify::BlockShape shape = worst_block(*found, after);
  const double slack = 1e-6;  // equal is good enough, whatever the rounding
  if (!shape.is_valid || shape.least_scaled_jacobian < worst_block(traced, before).least_scaled_jacobian - slack)
    return std::nullopt;
  for (const auto& [key, value] : attempt.entries()) report.set(key, value);
  found->certificate.reason = fmt::format("{} separatrices that are followed to their ends make {} blocks, {} will do",
                                          traced.lines.size(), before.cycles.size(), after.cycles.size());
  return found;
}

SeparatrixGraph automatic_layout(const field::FieldEvaluator& evaluator, const CriticalPoints& points,
                                 const LayoutOptions& options, Report& report) {
  trace::fixed_nodes(evaluator.field().mesh.face, points);  // nodes that no way can use are said at once
  const int num_lines = trace::num_launches(points);
  std::string reason = fmt::format("{} separatrices are too many to be followed to their ends", num_lines);
  if (num_lines <= most_traced_lines) {
    try {
      SeparatrixGraph graph = trace_separatrices(evaluator, points, options, report);
      std::string way = "traced";
      if (has_too_many_blocks(graph))
        if (auto fewer = layout_of_fewer_blocks(evaluator, points, options, graph, report)) {
          graph = std::move(*fewer);
          way = "quantized";
          report.set("layout.reason", graph.certificate.reason);
        }
      report.set("layout.way", way);
      certify(evaluator, way, graph, report);
      return graph;
    } catch (const ComputeError& error) {
      reason = error.what();
    }
  }
  report.set("layout.way", "quantized");
  report.set("layout.reason", reason);
  try {
    SeparatrixGraph graph = quantized_layout(evaluator, points, options, report);
    graph.certificate.reason = reason;
    certify(evaluator, "quantized", graph, report);
    report.warn("W-SEP-001", reason + ": lines were stopped where they meet and carried on by whole numbers instead");
    return graph;
  } catch (const ComputeError& error) {
    throw ComputeError(reason + "; stopped where they meet: " + error.what());
  }
}

}  // namespace

SeparatrixGraph lay_out(const field::FieldEvaluator& evaluator, const CriticalPoints& points,
                        const LayoutOptions& options, Report& report) {
  options.validate();
  if (options.layout == "auto") return automatic_layout(evaluator, points, options, report);
  SeparatrixGraph graph = options.layout == "t-mesh"
                              ? quantize::TMeshTracer(evaluator, points, options.trace).trace(report)
                          : options.layout == "quantized" ? quantized_layout(evaluator, points, options, report)
                                                          : trace_separatrices(evaluator, points, options, report);
  certify(evaluator, options.layout, graph, report);
  return graph;
}

}  // namespace quadrille::layout
