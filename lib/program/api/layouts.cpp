#include "api/layouts.hpp"

#include "base/error.hpp"
#include "block/make_blocks.hpp"
#include "block/name_blocks.hpp"
#include "check/check.hpp"
#include "choice/choose_nodes.hpp"
#include "field/check_nodes_match_field.hpp"
#include "field/error_estimate.hpp"
#include "layout/certificate.hpp"
#include "layout/fine_tolerance.hpp"
#include "layout/quantized_layout.hpp"
#include "layout/trace_separatrices.hpp"
#include "refine/refine.hpp"
#include "sizing/automatic_sizes.hpp"
#include "sizing/make_size_field.hpp"

namespace quadrille::api {
namespace {

void add_warnings(const Report& report, std::vector<std::string>* warnings) {
  if (!warnings) return;
  for (const Report::Warning& warning : report.warnings()) warnings->push_back(warning.message);
}

graph::CandidateLayout certified(const field::FieldEvaluator& evaluator, const CriticalPoints& points,
                                 const layout::LayoutOptions& options, LayoutMethod method, Report& report) {
  const auto compute = [&](const layout::LayoutOptions& o) {
    return method == LayoutMethod::quantized ? layout::quantized_layout(evaluator, points, o, report)
                                             : layout::trace_separatrices(evaluator, points, o, report);
  };
  graph::CandidateLayout made = layout::with_fine_tolerance(options, report, compute);
  layout::certify(evaluator, method, made, report);
  return made;
}

graph::CandidateLayout traced_or_quantized(const field::FieldEvaluator& evaluator, const CriticalPoints& points,
                                           const layout::LayoutOptions& options, Report& report) {
  std::string reason;
  try {
    return certified(evaluator, points, options, LayoutMethod::traced, report);
  } catch (const ComputeError& error) {
    reason = error.what();
  }
  graph::CandidateLayout made = certified(evaluator, points, options, LayoutMethod::quantized, report);
  made.certificate.reason = reason;
  return made;
}

}  // namespace

CriticalPoints find_nodes(const Field& field, std::vector<std::string>* warnings) {
  if (field.kind != FieldKind::harmonic) throw UsageError("the field is of the phase form: its nodes were prescribed");
  Report report;
  Field estimated = field;
  if (estimated.elem_error.empty()) estimated.elem_error = field::error_estimate(estimated);
  CriticalPoints points = choice::choose_nodes(estimated, {}, 1, report);
  points.provenance = field.provenance;
  add_warnings(report, warnings);
  return points;
}

SeparatrixGraph trace_layout(const Field& field, const CriticalPoints& points, const TraceSettings& settings,
                             std::vector<std::string>* warnings) {
  layout::LayoutOptions options;
  options.trace.merge_distance = settings.merge_distance;
  options.max_deviation = settings.max_deviation;
  options.validate();
  const field::FieldEvaluator evaluator(field, field::FarTerms::expanded);
  check::require_valid(check::check_critical_points_of(points, field.mesh), "the nodes");
  field::check_nodes_match_field(evaluator, points);
  Report report;
  const LayoutMethod method = settings.way == LayoutWay::quantized ? LayoutMethod::quantized : LayoutMethod::traced;
  SeparatrixGraph graph = graph::separatrix_graph(settings.way == LayoutWay::automatic
                                                      ? traced_or_quantized(evaluator, points, options, report)
                                                      : certified(evaluator, points, options, method, report));
  graph.provenance = field.provenance;
  add_warnings(report, warnings);
  return graph;
}

BlockLayout make_blocks(const SeparatrixGraph& graph, std::vector<std::string>* warnings) {
  Report report;
  block::Blocks blocks = block::make_blocks(graph, report);
  block::name_blocks(blocks.layout, {});
  blocks.layout.provenance = graph.provenance;
  add_warnings(report, warnings);
  return std::move(blocks.layout);
}

QuadMesh make_quads(const BlockLayout& layout, const QuadSettings& settings, std::vector<std::string>* warnings) {
  Report report;
  refine::RefineOptions options;
  options.order = settings.order;
  sizing::SizeOptions sizes;
  sizes.size = settings.size;
  sizes = sizing::with_curve_sizes(sizing::MeasuredLayout(layout), sizes, options.size_rule);
  options.size_field = sizing::make_size_field(layout.face, sizes);
  QuadMesh mesh = refine::refine(layout, options, report);
  mesh.provenance = layout.provenance;
  add_warnings(report, warnings);
  return mesh;
}

}  // namespace quadrille::api
