#include "refine/split_mesh.hpp"

#include <algorithm>
#include <utility>

#include "mesh/element_sizes.hpp"
#include "refine/chosen_blocks.hpp"
#include "refine/divide_arcs.hpp"
#include "refine/split_isoparametric.hpp"
#include "refine/validity.hpp"
#include "sizing/element_limit.hpp"

namespace quadrille::refine {
namespace {

constexpr double least_tolerance = 0.5;  ///< of the boundary's, is left for divisions however far splines were moved

std::vector<sizing::ChordCount> all_counts(const SplitRequest& request, const SplitSettings& settings) {
  std::vector<sizing::ChordCount> counts = request.options.counts;
  counts.insert(counts.end(), settings.counts.begin(), settings.counts.end());
  return counts;
}

std::vector<sizing::ChordPlan> plan_chords(const SplitRequest& request, const SplitSettings& settings) {
  const RefineOptions& options = request.options;
  const sizing::MeasuredLayout& measured = layout_of(request, settings);
  std::vector<sizing::ChordPlan> plans =
      sizing::grade_chords(measured, request.sizes, options.size_rule, all_counts(request, settings));
  for (const sizing::ChordCount& c : settings.counts) plans[c.chord].is_by_user = false;
  sizing::add_ring_rows(request.rings, plans);
  prescribe::apply_end_gradings(measured, options.end_gradings, options.end_growth, plans);
  apply_length_limits(settings.length_limits, plans);
  sizing::require_planned_within(measured, plans, {options.max_elements, options.order}, request.report);
  return plans;
}

/// The divisions of the last attempt, if they were made for the same parameters and tolerance. Walls change divisions.
KnownDivisions known_divisions(const SplitMesh* last, const SplitSettings& settings) {
  if (!last || last->walls || last->settings.tolerance != settings.tolerance ||
      last->settings.is_aligned != settings.is_aligned)
    return {};
  return {&last->plans, &last->divisions};
}

/// Layers along walls, and smooth divisions from wall to wall.
void plan_walls(const SplitRequest& request, SplitMesh& result) {
  const layers::WallInput input = wall_input(request, result.settings);
  result.walls = layers::plan_walls(input, result.divisions);
  if (!result.settings.limits_growth) return;
  const growth::KeptChords kept =
      growth::kept_chords(input.measured, all_counts(request, result.settings), request.options.end_gradings);
  result.growth = growth::smooth_arcs(input, request.limits.growth, kept, *result.walls, result.divisions);
}

/// With corrected lines inside the blocks that these do not make worse.
void smooth_lines(const SplitRequest& request, SplitMesh& result) {
  const std::vector<double> without_lines = mesh::block_skewness(result.mesh);
  result.lines.lengths = growth::line_intervals(layout_of(request, result.settings), *result.walls, result.divisions,
                                                request.limits.growth, request.options.order);
  do {
    const QuadMesh known = std::move(result.mesh);
    sample_mesh(request, &known, result);
  } while (growth::drop_worse(without_lines, result.mesh, result.walls->walls, result.lines.lengths));
}

}  // namespace

SplitSettings first_settings(const SplitRequest& request) {
  const RefineOptions& options = request.options;
  const double tolerance = request.limits.distance, fit = request.equal.blocks().face.fit_distance;
  SplitSettings settings;
  settings.limits_growth = request.limits.growth > 0;
  settings.is_aligned = !request.aligned.has_equal_parameters();
  if (!options.blocks.empty()) settings.counts = coarse_counts(request.equal, options.blocks, options.counts);
  settings.tolerance = std::max(tolerance - fit, least_tolerance * tolerance);
  settings.max_elements = options.max_elements;
  return settings;
}

const sizing::MeasuredLayout& layout_of(const SplitRequest& request, const SplitSettings& settings) {
  return settings.is_aligned ? request.aligned : request.equal;
}

DivideOptions divide_options(const SplitRequest& request, const SplitSettings& settings) {
  return {request.options.order, settings.tolerance, request.options.size_rule == sizing::SizeRule::error};
}

layers::WallInput wall_input(const SplitRequest& request, const SplitSettings& settings) {
  const RefineOptions& options = request.options;
  return {layout_of(request, settings), options.walls,          request.sizes, options.order,
          settings.tolerance,           settings.limits_growth, options.counts};
}

SplitMesh split(const SplitRequest& request, const SplitSettings& settings, const SplitMesh* last) {
  const RefineOptions& options = request.options;
  const sizing::MeasuredLayout& measured = layout_of(request, settings);
  SplitMesh result{settings, plan_chords(request, settings)};
  result.divisions = divide_arcs(measured, result.plans, divide_options(request, settings), request.report.progress(),
                                 known_divisions(last, settings));
  if (!options.walls.empty()) plan_walls(request, result);
  std::vector<std::vector<double>> no_layers;
  match_periodic(measured.periodic_arcs(), result.divisions, result.walls ? result.walls->arc_nodes : no_layers);
  sizing::require_divided_within(measured.blocks(), result.divisions, {settings.max_elements, options.order});
  sample_mesh(request, last ? &last->mesh : nullptr, result);
  if (result.growth) smooth_lines(request, result);
  result.distance = mesh::boundary_distance(result.mesh);
  set_score(request, result);
  return result;
}

void sample_mesh(const SplitRequest& request, const QuadMesh* known, SplitMesh& result) {
  result.mesh = split_isoparametric(layout_of(request, result.settings), result.divisions, request.options.order,
                                    result.walls ? &*result.walls : nullptr, result.lines);
  measure_elements(result.mesh, request.report.progress(), known);
}

void set_score(const SplitRequest& request, SplitMesh& result) {
  mesh::measure_element_sizes(result.mesh);
  result.score = mesh::mesh_score(result.mesh, result.distance, request.limits,
                                  elements_on_layered_chords(request.equal.blocks(), result));
}

std::vector<bool> elements_on_layered_chords(const BlockLayout& blocks, const SplitMesh& split) {
  std::vector<bool> is_layered;
  if (!split.walls) return is_layered;
  for (const int block : split.mesh.elem_block) {
    const auto& arcs = blocks.block2arcs[block];
    is_layered.push_back(split.walls->is_graded[arcs[0].arc] || split.walls->is_graded[arcs[1].arc]);
  }
  return is_layered;
}

void set_prescribed_lengths(const SplitRequest& request, SplitMesh& split) {
  QuadMesh& mesh = split.mesh;
  mesh.elem_prescribed_length.clear(), mesh.elem_prescribed_stretch.clear();
  const std::vector<bool> is_layered = elements_on_layered_chords(request.equal.blocks(), split);
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const bool is_by_layers = !is_layered.empty() && is_layered[elem];
    const sizing::DirectedSize size =
        request.sizes.directed(mesh::centre(mesh, elem), request.equal.region_of_block(mesh.elem_block[elem]));
    mesh.elem_prescribed_length.push_back(is_by_layers ? 0 : size.size);
    if (request.sizes.has_metric()) mesh.elem_prescribed_stretch.push_back(size.stretch);
  }
}

}  // namespace quadrille::refine
