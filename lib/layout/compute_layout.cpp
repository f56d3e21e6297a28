#include "layout/compute_layout.hpp"

#include <utility>

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

graph::CandidateLayout automatic_layout(const field::FieldEvaluator& evaluator, const CriticalPoints& points,
                                        const LayoutOptions& options, Report& report) {
  trace::fixed_nodes(evaluator.field().mesh.face, points);  // throws at once where no method could use the nodes
  const auto traced = [&](Report& r) { return trace_separatrices(evaluator, points, options, r); };
  const auto quantized = [&](Report& r) { return quantized_layout(evaluator, points, options, r); };
  ChosenLayout chosen = choose_layout(trace::num_launches(points), attempting(traced), attempting(quantized), report);
  certify(evaluator, chosen.method, chosen.layout, report);
  if (!chosen.warning.empty()) report.warn(warning::quantized_instead_of_traced, chosen.warning);
  return std::move(chosen.layout);
}

graph::CandidateLayout prescribed_layout(const field::FieldEvaluator& evaluator, const CriticalPoints& points,
                                         const LayoutOptions& options, Report& report) {
  graph::CandidateLayout layout =
      options.layout == "t-mesh"      ? quantize::TMeshTracer(evaluator, points, options.trace).trace(report)
      : options.layout == "quantized" ? quantized_layout(evaluator, points, options, report)
                                      : trace_separatrices(evaluator, points, options, report);
  certify(evaluator, options.layout, layout, report);
  return layout;
}

}  // namespace

SeparatrixGraph compute_layout(const field::FieldEvaluator& evaluator, const CriticalPoints& points,
                               const LayoutOptions& options, Report& report) {
  options.validate();
  const bool is_automatic = options.layout == "auto";
  graph::CandidateLayout layout = is_automatic ? automatic_layout(evaluator, points, options, report)
                                               : prescribed_layout(evaluator, points, options, report);
  report.set("subdivision.built", graph::Subdivision::num_built());
  return graph::separatrix_graph(std::move(layout));
}

}  // namespace quadrille::layout
