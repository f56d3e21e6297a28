#include "api/layouts.hpp"

#include <algorithm>
#include <memory>

#include "base/error.hpp"
#include "block/make_blocks.hpp"
#include "block/name_blocks.hpp"
#include "check/check.hpp"
#include "features/automatic_size.hpp"
#include "features/resolve_features.hpp"
#include "field/check_nodes_match_field.hpp"
#include "field/error_estimate.hpp"
#include "galerkin/phase_energy.hpp"
#include "guide/complete_nodes.hpp"
#include "guide/divide_corners.hpp"
#include "guide/find_critical_points.hpp"
#include "guide/index_sum.hpp"
#include "guide/line_field.hpp"
#include "guide/resolve_clusters.hpp"
#include "layout/certificate.hpp"
#include "layout/fine_tolerance.hpp"
#include "layout/quantized_layout.hpp"
#include "layout/trace_separatrices.hpp"
#include "placement/place_nodes.hpp"
#include "refine/refine.hpp"
#include "sizing/make_size_field.hpp"
#include "ties/choose_at_ties.hpp"

namespace quadrille::api {
namespace {

constexpr int max_valence = 6;

void add_warnings(const Report& report, std::vector<std::string>* warnings) {
  if (!warnings) return;
  for (const Report::Warning& warning : report.warnings()) warnings->push_back(warning.message);
}

CriticalPoints zeros_of(const field::FieldEvaluator& evaluator, galerkin::PhaseSolver& solver, Report& report) {
  const CadFace& face = evaluator.field().mesh.face;
  const ties::TieOrbits ties = ties::tie_orbits(face);
  if (!ties.ties.empty()) {
    const auto solve = [&](const std::vector<field::LiftedData>& data) { return solver.harmonic_parts(data); };
    return ties::choose_at_ties(evaluator, ties, solve, {{}, max_valence}, report);
  }
  CriticalPoints points = guide::find_critical_points(evaluator, {}, report);
  guide::resolve_clusters(face, max_valence, points);
  return points;
}

CriticalPoints zeros_or_rule(const field::FieldEvaluator& evaluator, galerkin::PhaseSolver& solver, Report& report,
                             std::vector<std::string>* warnings) {
  try {
    return zeros_of(evaluator, solver, report);
  } catch (const ComputeError& error) {
    if (warnings) warnings->push_back(std::string(error.what()) + ": nodes are chosen by rule instead");
  }
  return guide::line_field_points(evaluator.field().mesh.face, max_valence);
}

void place(const CadFace& face, galerkin::PhaseSolver& solver, CriticalPoints& points, Report& report) {
  const std::vector<bool> is_free = guide::nodes_without_position(face, points);
  if (std::none_of(is_free.begin(), is_free.end(), [](bool free) { return free; })) return;
  const auto energy = [&](const CriticalPoints& at) {
    galerkin::PhaseEnergy e = solver.energy(phase_nodes_of(at), {points.hole_winding_offsets});
    return placement::NodeEnergy{e.value, std::move(e.gradient)};
  };
  placement::place_nodes(face, energy, is_free, {}, points, report);
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
  const CadFace& face = estimated.mesh.face;
  const field::FieldEvaluator evaluator(estimated);
  galerkin::PhaseSolver solver(estimated.mesh, estimated.elem_order);  // factored only if it is needed
  CriticalPoints points = zeros_or_rule(evaluator, solver, report, warnings);
  guide::divide_degenerate_corners(face, points);
  guide::report_sharp_corners(face, points, report);
  features::resolve_features(face, features::parse_feature_size("auto", face), points);
  guide::require_index_sum(points);
  place(face, solver, points, report);
  guide::complete_nodes(evaluator, points);
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
  check::require_valid(check::check_critical_points_of(points, field), "the nodes");
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
  options.size_field = sizing::make_size_field(layout.face, sizes);
  QuadMesh mesh = refine::refine(layout, options, report);
  mesh.provenance = layout.provenance;
  add_warnings(report, warnings);
  return mesh;
}

}  // namespace quadrille::api
