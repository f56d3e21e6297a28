#include "refine/split_mesh.hpp"

#include <algorithm>
#include <functional>

#include "refine/split_isoparametric.hpp"
#include "refine/validity.hpp"
#include "sizing/element_limit.hpp"
#include "sizing/match_periodic.hpp"

namespace quadrille::refine {
namespace {

/// The divisions of the last attempt, if they were made for the same parameters and tolerance. Walls change divisions.
KnownDivisions known_divisions(const SplitRequest& request, const SplitMesh& now) {
  const SplitMesh* last = request.last;
  if (!last || last->walls || last->tolerance != now.tolerance ||
      last->has_equal_parameters != now.has_equal_parameters)
    return {};
  return {&last->plans, &last->divisions};
}

/// Layers along walls, and smooth divisions from wall to wall.
void plan_walls(const sizing::MeasuredLayout& measured, const SplitRequest& request,
                const std::vector<sizing::ChordCount>& counts, SplitMesh& result) {
  const RefineOptions& options = request.options;
  const layers::WallInput input{measured,
                                options.walls,
                                request.sizes,
                                request.division.order,
                                request.division.tolerance,
                                request.limits_growth,
                                options.counts};
  result.walls = layers::plan_walls(input, result.divisions);
  if (!request.limits_growth) return;
  result.growth =
      growth::smooth_arcs(input, options.target_growth, growth::kept_chords(measured, counts, options.end_gradings),
                          *result.walls, result.divisions);
}

}  // namespace

QuadMesh measured_mesh(const sizing::MeasuredLayout& measured, const SplitRequest& request, const SplitMesh& result,
                       const QuadMesh* known) {
  QuadMesh mesh = split_isoparametric(measured, result.divisions, request.options.order,
                                      result.walls ? &*result.walls : nullptr, result.lines);
  measure_elements(mesh, request.report->progress(), known);
  return mesh;
}

SplitMesh split(const sizing::MeasuredLayout& measured, const SplitRequest& request,
                const std::vector<sizing::ChordCount>& coarse) {
  request.attempt->advance();
  const RefineOptions& options = request.options;
  std::vector<sizing::ChordCount> counts = options.counts;
  counts.insert(counts.end(), coarse.begin(), coarse.end());
  std::vector<sizing::ChordPlan> plans = sizing::grade_chords(measured, request.sizes, options.size_rule, counts);
  prescribe::apply_end_gradings(measured, options.end_gradings, options.end_growth, plans);
  sizing::apply_length_limits(request.limits, plans);
  const sizing::ElementLimit limit{options.max_elements, options.order};
  sizing::require_planned_within(measured, plans, limit, *request.report);
  SplitMesh result;
  result.shortened_chords =
      static_cast<int>(std::ranges::count_if(request.limits, std::not_fn(&sizing::LengthLimits::value_type::empty)));
  result.tolerance = request.division.tolerance;
  result.has_equal_parameters = measured.has_equal_parameters();
  result.divisions =
      divide_arcs(measured, plans, request.division, request.report->progress(), known_divisions(request, result));
  result.plans = std::move(plans);
  if (!options.walls.empty()) plan_walls(measured, request, counts, result);
  std::vector<std::vector<double>> no_layers;
  sizing::match_periodic(measured.periodic_arcs(), result.divisions,
                         result.walls ? result.walls->arc_nodes : no_layers);
  sizing::require_divided_within(measured.blocks(), result.divisions, {request.max_elements, options.order});
  result.mesh = measured_mesh(measured, request, result, request.last ? &request.last->mesh : nullptr);
  if (!result.growth) return result;
  const std::vector<double> without_lines = growth::block_qualities(result.mesh);
  result.lines.lengths =
      growth::line_intervals(measured, *result.walls, result.divisions, options.target_growth, options.order);
  do result.mesh = measured_mesh(measured, request, result, &result.mesh);
  while (growth::drop_worse(without_lines, result.mesh, result.walls->walls, result.lines.lengths));
  return result;
}

}  // namespace quadrille::refine
