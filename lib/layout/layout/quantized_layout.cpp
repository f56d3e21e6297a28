#include "layout/quantized_layout.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "base/error.hpp"
#include "base/position_text.hpp"
#include "curve/nurbs.hpp"
#include "layout/strip_remedies.hpp"
#include "quantize/quantize_and_extend.hpp"
#include "quantize/t_mesh.hpp"
#include "simplify/simplify.hpp"

namespace quadrille::layout {
namespace {

[[noreturn]] void fail_to_quantize(const quantize::InfeasibleTMesh& failed, const CriticalPoints& points,
                                   Report& report) {
  const std::vector<int> zero_arcs = failed.zero_arcs();
  if (failed.strips.empty() || zero_arcs.empty())
    throw ComputeError("no integer lengths were found for the arcs of the T-mesh");
  const ArcGraph& t_mesh = failed.t_mesh.graph();
  const std::vector<std::string> remedies = strip_remedies(t_mesh, failed.strips.front(), points);
  report.set("quantize.remedies", fmt::format("{}", fmt::join(remedies, ", ")));
  const ArcPiece& piece = t_mesh.arcs[zero_arcs.front()].pieces.front();
  const Vec2 position = curve::point(t_mesh.curve(piece.curve), (piece.t0 + piece.t1) / 2) + t_mesh.face.origin;
  throw ComputeError(fmt::format(
      "no whole numbers of elements fit this field: a strip of blocks winds onto itself, and {} arcs of the T-mesh "
      "have length 0 in every solution, the first at {}",
      zero_arcs.size(), position_text(position)));
}

}  // namespace

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
