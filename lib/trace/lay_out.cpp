#include "trace/lay_out.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "curve/chain.hpp"
#include "trace/extend_lines.hpp"
#include "trace/quantize.hpp"
#include "trace/t_mesh.hpp"

namespace quadrille {
namespace {

// An arc of this share of the diameter has length one.
constexpr double unit_share = 0.1;

std::vector<double> arc_lengths(const SeparatrixGraph& graph) {
  const CurveTable table(graph.face, graph.splines);
  std::vector<double> lengths;
  for (const GraphArc& arc : graph.arcs) lengths.push_back(Chain(table, arc.pieces).length());
  return lengths;
}

SeparatrixGraph quantized_layout(const FieldEvaluator& evaluator, const CriticalPoints& points,
                                 const TraceOptions& options, Report& report) {
  const SeparatrixGraph t_mesh = trace_t_mesh(evaluator, points, options, report);
  const std::vector<TFace> faces = t_mesh_faces(t_mesh);
  const std::vector<int> lengths = quantize(t_mesh, faces, arc_lengths(t_mesh), unit_share * t_mesh.face.diameter);
  report.set("quantize.longest_arc", lengths.empty() ? 0 : *std::max_element(lengths.begin(), lengths.end()));
  SeparatrixGraph graph = extend_lines(t_mesh, faces, lengths);
  report.set("quantize.faces", planar_faces(graph).cycles.size());
  return graph;
}

}  // namespace

SeparatrixGraph lay_out(const FieldEvaluator& evaluator, const CriticalPoints& points, const TraceOptions& options,
                        Report& report) {
  if (options.layout == "t-mesh") return trace_t_mesh(evaluator, points, options, report);
  if (options.layout == "quantized") return quantized_layout(evaluator, points, options, report);
  return trace_separatrices(evaluator, points, options, report);
}

}  // namespace quadrille
