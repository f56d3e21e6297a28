#include "refine/refine.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/warning_codes.hpp"
#include "check/check.hpp"
#include "mesh/element_sizes.hpp"
#include "mesh/nested_quads.hpp"
#include "refine/align_chords.hpp"
#include "refine/best_split.hpp"
#include "refine/even_vertices.hpp"
#include "refine/joint_vertices.hpp"
#include "refine/lifted_split.hpp"
#include "refine/lower_error.hpp"
#include "refine/surface_tips.hpp"
#include "refine/validity.hpp"
#include "sizing/chart_scale.hpp"
#include "sizing/element_limit.hpp"
#include "sizing/halved_blocks.hpp"
#include "sizing/report_sizes.hpp"

namespace quadrille::refine {
namespace {

constexpr double default_size = 1.0 / 20;  ///< diameters

sizing::SizeField size_field(const RefineOptions& options, const CadFace& face) {
  if (options.size_field) return *options.size_field;
  return sizing::SizeField(options.size > 0 ? options.size : face.diameter * default_size)
      .in_chart(sizing::chart_scale(face));
}

/// In diameters.
double geometric_tolerance(const RefineOptions& options) {
  return options.geometry_tol > 0 ? options.geometry_tol : default_geometry_tol(options.order);
}

mesh::ScoreLimits score_limits(const RefineOptions& options, const CadFace& face) {
  return {face.diameter * geometric_tolerance(options), options.target_edge_ratio,
          options.walls.empty() ? 0 : options.target_growth};
}

/// Of the chords with the layers along walls, if boundaries share out their numbers.
std::vector<prescribe::LayeredCount> layered_counts(const SplitRequest& request) {
  const RefineOptions& options = request.options;
  if (options.walls.empty() || options.boundary_counts.empty()) return {};
  SplitSettings settings = first_settings(request);
  settings.is_aligned = false;
  return layers::layered_counts(wall_input(request, settings),
                                sizing::grade_chords(request.equal, request.sizes, options.size_rule, options.counts));
}

/// Vertices must move to the lengths of rings, and half of a hole has none.
std::vector<sizing::HoleRing> rings_of(const SplitRequest& request) {
  const RefineOptions& options = request.options;
  if (options.rings == Rings::none || request.sizes.has_metric() || options.size_rule != sizing::SizeRule::error ||
      !options.symmetry.empty())
    return {};
  return sizing::hole_rings(request.equal, request.sizes);
}

/// The parts of an element are the same map: the distance from the CAD curves does not change.
void refine_nested(QuadMesh& mesh, const RefineOptions& options, Report& report) {
  if (options.levels == 0) return;
  sizing::require_nested_within(mesh.num_elems(), options.levels, {options.max_elements, options.order});
  mesh = mesh::nested_quads(mesh, options.levels);
  measure_elements(mesh, report.progress());
  mesh::measure_element_sizes(mesh);
}

void report_split(const SplitRequest& request, const SplitMesh& split) {
  Report& report = request.report;
  report.set("count_doublings", split.settings.doublings);
  report.set("shortened_chords",
             std::ranges::count_if(split.settings.length_limits, [](const auto& limits) { return !limits.empty(); }));
  report.set("chords", request.equal.chords().size());
  sizing::report_rings(request.rings, report);
  report_mesh(split.mesh, report);
  mesh::report_distance(split.distance, split.mesh.face, request.limits.distance, report);
  if (split.walls) layers::report_walls(*split.walls, request.options.walls, report);
  if (request.limits.growth > 0)
    growth::report_growth(split.growth, split.lines, split.mesh, request.limits.growth, report);
}

/// `counts`: those of single chords, `layered` those of chords with layers, in which those of boundaries result.
void report_prescribed(const SplitRequest& request, const SplitMesh& split,
                       const std::vector<sizing::ChordCount>& counts,
                       const std::vector<prescribe::LayeredCount>& layered) {
  const RefineOptions& options = request.options;
  const sizing::MeasuredLayout& measured = request.equal;
  Report& report = request.report;
  sizing::report_sizes(measured, split.divisions, request.sizes, counts, report);
  sizing::report_resolution(measured, split.mesh, report);
  prescribe::report_boundary_counts(measured, split.divisions, options.boundary_counts, layered, report);
  prescribe::report_end_gradings(measured, split.divisions, options.end_gradings, options.end_growth, options.counts,
                                 report);
}

/// The best mesh of the request, its vertices placed.
SplitMesh placed_split(const SplitRequest& request) {
  const RefineOptions& options = request.options;
  SplitMesh split = best_split(request).split;
  if (options.size_rule == sizing::SizeRule::error) {
    lower_error(request, split);
    return split;
  }
  place_vertices(request, split, options.least_progress);
  if (std::optional<SplitMesh> shorter = with_shorter_elements(request, split)) {
    place_vertices(request, *shorter, options.least_progress);
    if (mesh::is_better(shorter->score, split.score)) split = std::move(*shorter);
  }
  set_prescribed_lengths(request, split);
  return split;
}

/// No value if it would have too many elements.
std::optional<SplitMesh> finer_split(const SplitRequest& request) {
  try {
    return placed_split(request);
  } catch (const sizing::TooManyElements&) {
    return std::nullopt;
  }
}

/// The same on a surface, with shorter edges where it is too far away, or an element is not proved in space: the
/// nearest of these meshes. `tolerance`: a length in space. `there`: the mesh, lifted.
SplitMesh lifted_split(const mesh::ChartMap& map, double tolerance, const SurfaceTraits& surface, SplitRequest& request,
                       LiftedMesh& there) {
  SplitMesh best = placed_split(request);
  there = lifted(map, best.mesh, surface, request.report.progress());
  LiftedMesh last = there;
  int num_slow = 0, num_approaches = 0;
  for (int round = 0; round - num_approaches < max_lifts && num_slow < max_slow_lifts; ++round) {
    const int power = expected_power(round, best.mesh.order);
    const std::vector<sizing::SizeSegment> finer = finer_sizes(map, last, request.sizes, tolerance, power);
    if (finer.empty()) break;
    request.sizes = request.sizes.with(finer);
    request.sizes_at_bends = sizing::sizes_at_bends(request.equal.blocks().face, request.sizes);
    std::optional<SplitMesh> next = finer_split(request);
    if (!next) break;
    LiftedMesh next_there = lifted(map, next->mesh, surface, request.report.progress());
    if (next_there.mesh.nodes == last.mesh.nodes) break;
    const bool is_slow = fell_slowly(last, next_there, tolerance, power);
    const bool is_approach = is_slow && is_resolving_bend(map, last, next_there, max_lifts - num_approaches);
    num_approaches += is_approach;
    num_slow = is_slow && !is_approach ? num_slow + 1 : 0;
    if (is_nearer(next_there, there)) best = std::move(*next), there = next_there;
    last = std::move(next_there);
  }
  add_tip_rings(map, surface, tolerance, request.options.max_elements, best.mesh, there, request.report.progress());
  there.is_smooth = num_slow == 0;
  return best;
}

}  // namespace

QuadMesh refine(const BlockLayout& layout, const RefineOptions& prescribed, Report& report) {
  prescribed.validate();
  require_periodic_arcs(layout, "make the blocks again (separatrix, blocksplit)");
  const sizing::MeasuredLayout measured(layout);
  const sizing::MeasuredLayout upright = measured.with_parameters(align_chords(measured));
  const sizing::MeasuredLayout aligned = sizing::with_lines_of_whole(upright, prescribed.symmetry);
  RefineOptions options = prescribed;
  // The growth from wall to wall determines counts; and vertices that stay have other parts of the error.
  if (options.size_rule == sizing::SizeRule::error &&
      (!options.walls.empty() || !options.blocks.empty() || options.relax != Relax::size))
    options.size_rule = sizing::SizeRule::nearest;
  SplitRequest request{options, measured, aligned, size_field(options, layout.face), score_limits(options, layout.face),
                       report};
  request.rings = rings_of(request);
  const std::vector<prescribe::LayeredCount> layered = layered_counts(request);
  options.counts = prescribe::with_boundary_counts(measured, request.sizes, options.counts, options.boundary_counts,
                                                   layered, options.end_gradings, options.end_growth);
  std::optional<mesh::ChartMap> map;
  if (layout.face.chart) map.emplace(layout.face);
  LiftedMesh there;
  SurfaceTraits surface;
  if (map) surface = {surface_tips(*layout.face.chart), end_mirror(*map, layout.face)};
  const double tolerance =
      options.keeps_to_surface ? geometric_tolerance(options) * sizing::diameter_in_space(layout.face) : HUGE_VAL;
  SplitMesh split = map ? lifted_split(*map, tolerance, surface, request, there) : placed_split(request);
  warn_of_joints(split.mesh, report);
  report_even_counts(split.mesh, options.boundary_counts, report);
  refine_nested(split.mesh, options, report);
  if (map) {
    const bool is_smooth = there.is_smooth;
    if (options.levels > 0) there = lifted(*map, std::move(split.mesh), surface, report.progress());
    there.is_smooth = is_smooth;
    report_surface(there, tolerance, report);
    split.mesh = std::move(there.mesh);
  }
  report_split(request, split);
  report_prescribed(request, split, prescribed.counts, layered);
  if (!options.allow_invalid) require_valid_elements(split.mesh);
  require_quality(split.mesh, options.min_scaled_jacobian, options.max_edge_ratio);
  if (!split.mesh.is_valid) report.warn(warning::mesh_not_valid, check::validity_warning(split.mesh));
  return std::move(split.mesh);
}

}  // namespace quadrille::refine
