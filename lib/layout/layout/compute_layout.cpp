#include "layout/compute_layout.hpp"

#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/tolerance.hpp"
#include "base/warning_codes.hpp"
#include "graph/crossings.hpp"
#include "layout/certificate.hpp"
#include "layout/choose_layout.hpp"
#include "layout/midpoint_layout.hpp"
#include "layout/quantized_layout.hpp"
#include "layout/trace_separatrices.hpp"
#include "quantize/t_mesh.hpp"
#include "trace/launch.hpp"
#include "trace/merged_lines.hpp"

namespace quadrille::layout {
namespace {

constexpr double refinement = 100;
constexpr double finest_tolerance = 1e-12 * (1 - tolerance::tied);  // in diameters; round-off makes finer ones useless

// Only here an error is converted to the reason why there is no layout.
template <class Layout>
LayoutComputation attempting(const char* name, const Layout& layout) {
  return [&layout, name](Report& report) -> LayoutAttempt {
    const Progress::Part part(report.progress(), name);
    try {
      return {layout(report), ""};
    } catch (const graph::CrowdedLinesError& error) {
      return {std::nullopt, error.what(), true};
    } catch (const ComputeError& error) {
      return {std::nullopt, error.what()};
    }
  };
}

// How many times more arcs than options.max_lines are allowed where there is no other layout of separatrices.
constexpr int crowding = 10;

const char* warning_code(LayoutMethod method) {
  if (method == LayoutMethod::midpoint) return warning::midpoint_instead_of_separatrices;
  return method == LayoutMethod::quantized ? warning::quantized_instead_of_traced : warning::crowded_separatrices;
}

graph::CandidateLayout automatic_layout(const field::FieldEvaluator& evaluator, const CriticalPoints& points,
                                        const LayoutOptions& options, Report& report) {
  const auto tracing = [&](int times) {
    return [&evaluator, &points, &options, times](Report& r) {
      LayoutOptions more = options;
      more.max_lines *= times;
      return with_fine_tolerance(more, r,
                                 [&](const LayoutOptions& o) { return trace_separatrices(evaluator, points, o, r); });
    };
  };
  const auto traced = tracing(1), crowded = tracing(crowding);
  const auto quantized = [&](Report& r) {
    return with_fine_tolerance(options, r,
                               [&](const LayoutOptions& o) { return quantized_layout(evaluator, points, o, r); });
  };
  const auto midpoint = [&](Report& r) {
    const Progress::Part part(r.progress(), "midpoint");
    return midpoint_layout(evaluator.field().mesh, options.coarse_mesher, r);
  };
  ChosenLayout chosen =
      choose_layout(trace::num_launches(points),
                    {attempting("traced", traced), attempting("quantized", quantized), attempting("crowded", crowded),
                     options.coarse_mesher ? CertainLayout(midpoint) : CertainLayout()},
                    report);
  certify(evaluator, chosen.method, chosen.layout, report);
  if (!chosen.warning.empty()) report.warn(warning_code(chosen.method), chosen.warning);
  return std::move(chosen.layout);
}

graph::CandidateLayout prescribed_layout(const field::FieldEvaluator& evaluator, const CriticalPoints& points,
                                         const LayoutOptions& options, LayoutMethod method, Report& report) {
  const auto compute = [&](const LayoutOptions& o) {
    switch (method) {
      case LayoutMethod::t_mesh:
        return quantize::TMeshTracer(evaluator, points, o.trace, report.progress()).trace(report);
      case LayoutMethod::quantized:
        return quantized_layout(evaluator, points, o, report);
      case LayoutMethod::midpoint:
        return midpoint_layout(evaluator.field().mesh, o.coarse_mesher, report);
      case LayoutMethod::traced:
        break;
    }
    return trace_separatrices(evaluator, points, o, report);
  };
  graph::CandidateLayout layout = with_fine_tolerance(options, report, compute);
  certify(evaluator, method, layout, report);
  return layout;
}

}  // namespace

graph::CandidateLayout with_fine_tolerance(LayoutOptions options, Report& report, const LayoutOfOptions& compute) {
  std::optional<Progress::Part> finer;
  for (;;) {
    try {
      return compute(options);
    } catch (const trace::FamilyOrderError&) {
      options.trace.tolerance /= refinement;
      if (options.trace.tolerance < finest_tolerance) throw;
      report.set("layout.tolerance", options.trace.tolerance);
      finer.emplace(report.progress(), "finer tolerance");
    }
  }
}

SeparatrixGraph compute_layout(const field::FieldEvaluator& evaluator, const CriticalPoints& points,
                               const LayoutOptions& options, Report& report) {
  options.validate();
  // None for `automatic`: choose_layout decides.
  const std::optional<LayoutMethod> method = enum_value<LayoutMethod>(enum_name(options.layout));
  graph::CandidateLayout layout = method ? prescribed_layout(evaluator, points, options, *method, report)
                                         : automatic_layout(evaluator, points, options, report);
  report.set("subdivision.built", layout.num_built);
  return graph::separatrix_graph(std::move(layout));
}

}  // namespace quadrille::layout
