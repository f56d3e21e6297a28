#include "layout/quantized_layout.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "base/position_text.hpp"
#include "curve/chain.hpp"
#include "curve/nurbs.hpp"
#include "layout/strip_remedies.hpp"
#include "quantize/extend_lines.hpp"
#include "quantize/quantize.hpp"
#include "quantize/t_mesh.hpp"
#include "quantize/t_mesh_faces.hpp"
#include "simplify/simplify.hpp"

namespace quadrille::layout {
namespace {

constexpr double relative_unit = 0.1;  // an arc of this length, relative to the diameter, has integer length one

std::vector<double> arc_lengths(const ArcGraph& graph) {
  const curve::CurveTable table(graph.face, graph.splines);
  std::vector<double> lengths;
  for (const GraphArc& arc : graph.arcs) {
    // The parameter of a line is its arc length; for a merged line approximately.
    const ArcPiece& piece = arc.pieces.front();
    lengths.push_back(arc.is_boundary ? curve::Chain(table, arc.pieces).length() : std::abs(piece.t1 - piece.t0));
  }
  return lengths;
}

[[noreturn]] void fail_to_quantize(const ArcGraph& t_mesh, const std::vector<int>& zero_arcs,
                                   const std::vector<int>& strip_arcs, const CriticalPoints& points, Report& report) {
  report.set("quantize.remedies", fmt::format("{}", fmt::join(strip_remedies(t_mesh, strip_arcs, points), ", ")));
  const ArcPiece& piece = t_mesh.arcs[zero_arcs.front()].pieces.front();
  const Vec2 position = curve::point(t_mesh.curve(piece.curve), (piece.t0 + piece.t1) / 2) + t_mesh.face.origin;
  throw ComputeError(fmt::format(
      "no whole numbers of elements fit this field: a strip of blocks winds onto itself, and {} arcs of the T-mesh "
      "have length 0 in every solution, the first at {}",
      zero_arcs.size(), position_text(position)));
}

struct QuantizedTMesh {
  graph::CandidateLayout t_mesh;
  std::vector<quantize::TFace> faces;
  std::vector<int> lengths;  // of the arcs
};

QuantizedTMesh quantized_t_mesh(quantize::TMeshTracer& tracer, const CriticalPoints& points, Report& report) {
  int num_built = 0;
  for (int num_rejected = 0;; ++num_rejected) {
    QuantizedTMesh q;
    q.t_mesh = tracer.trace(report);
    num_built = q.t_mesh.num_built += num_built;
    const Progress::Part part(report.progress(), "integer program");
    q.faces = quantize::t_mesh_faces(q.t_mesh.subdivision);
    const ArcGraph& graph = q.t_mesh.graph();
    quantize::Quantization found =
        quantize::quantize_or_explain(q.faces, arc_lengths(graph), relative_unit * graph.face.diameter);
    if (!found.lengths.empty()) {
      q.lengths = std::move(found.lengths);
      report.set("quantize.rejected_merges", num_rejected);
      report.set("quantize.merges_given_up", num_rejected);  // former name
      report.set("quantize.longest_arc", *std::max_element(q.lengths.begin(), q.lengths.end()));
      return q;
    }
    if (!found.strips.empty() && tracer.reject_merges(q.t_mesh.lines, found.strips)) continue;
    const std::vector<int> zero_arcs = quantize::forced_zero_arcs(q.faces, static_cast<int>(graph.arcs.size()));
    if (found.strips.empty() || zero_arcs.empty())
      throw ComputeError("no integer lengths were found for the arcs of the T-mesh");
    fail_to_quantize(graph, zero_arcs, found.strips.front(), points, report);
  }
}

}  // namespace

graph::CandidateLayout quantized_layout(const field::FieldEvaluator& evaluator, const CriticalPoints& points,
                                        const LayoutOptions& options, Report& report) {
  quantize::TMeshTracer tracer(evaluator, points, options.trace, report.progress());
  const QuantizedTMesh q = quantized_t_mesh(tracer, points, report);
  graph::CandidateLayout layout = [&] {
    const Progress::Part part(report.progress(), "continued lines");
    return quantize::extend_lines(q.t_mesh, q.faces, q.lengths);
  }();
  report.set("quantize.faces", layout.subdivision.num_faces());
  if (options.simplify != SimplifyLevel::none)
    layout = simplify::simplify(evaluator, std::move(layout), simplify_options(options), report);
  return layout;
}

}  // namespace quadrille::layout
