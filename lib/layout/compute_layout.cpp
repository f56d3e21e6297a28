#include "layout/compute_layout.hpp"

#include "base/error.hpp"
#include "base/warning_codes.hpp"
#include "layout/certificate.hpp"
#include "layout/choose_layout.hpp"
#include "layout/quantized_layout.hpp"
#include "layout/trace_separatrices.hpp"
#include "quantize/t_mesh.hpp"
#include "trace/fixed_nodes.hpp"
#include "trace/launch_all.hpp"

namespace quadrille::layout {
namespace {

// The one place where an error becomes the reason why there is no layout.
template <class Layout>
LayoutComputation attempting(const Layout& layout) {
  return [&layout](Report& report) -> LayoutAttempt {
    try {
      return {layout(report), ""};
    } catch (const ComputeError& error) {
      return {std::nullopt, error.what()};
    }
  };
}

SeparatrixGraph automatic_layout(const field::FieldEvaluator& evaluator, const CriticalPoints& points,
                                 const LayoutOptions& options, Report& report) {
  trace::fixed_nodes(evaluator.field().mesh.face, points);  // throws at once where no method could use the nodes
  const auto traced = [&](Report& r) { return trace_separatrices(evaluator, points, options, r); };
  const auto quantized = [&](Report& r) { return quantized_layout(evaluator, points, options, r); };
  ChosenLayout chosen = choose_layout(trace::num_launches(points), attempting(traced), attempting(quantized), report);
  certify(evaluator, chosen.method, chosen.graph, report);
  if (!chosen.warning.empty()) report.warn(warning::quantized_instead_of_traced, chosen.warning);
  return std::move(chosen.graph);
}

SeparatrixGraph prescribed_layout(const field::FieldEvaluator& evaluator, const CriticalPoints& points,
                                  const LayoutOptions& options, Report& report) {
  if (options.layout == "t-mesh") return quantize::TMeshTracer(evaluator, points, options.trace).trace(report);
  if (options.layout == "quantized") return quantized_layout(evaluator, points, options, report);
  return trace_separatrices(evaluator, points, options, report);
}

}  // namespace

SeparatrixGraph compute_layout(const field::FieldEvaluator& evaluator, const CriticalPoints& points,
                               const LayoutOptions& options, Report& report) {
  options.validate();
  if (options.layout == "auto") return automatic_layout(evaluator, points, options, report);
  SeparatrixGraph graph = prescribed_layout(evaluator, points, options, report);
  certify(evaluator, options.layout, graph, report);
  return graph;
}

}  // namespace quadrille::layout
