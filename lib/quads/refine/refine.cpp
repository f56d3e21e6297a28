#include "refine/refine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/warning_codes.hpp"
#include "check/check.hpp"
#include "growth/block_shifts.hpp"
#include "growth/smooth_walls.hpp"
#include "layers/wall_layers.hpp"
#include "mesh/boundary_distance.hpp"
#include "mesh/edge_growth.hpp"
#include "mesh/element_sizes.hpp"
#include "mesh/nested_quads.hpp"
#include "prescribe/chosen_blocks.hpp"
#include "refine/align_chords.hpp"
#include "refine/relax.hpp"
#include "refine/split_mesh.hpp"
#include "refine/validity.hpp"
#include "sizing/element_limit.hpp"
#include "sizing/grade_chords.hpp"
#include "sizing/length_limits.hpp"
#include "sizing/measured_layout.hpp"
#include "sizing/report_sizes.hpp"

namespace quadrille::refine {
namespace {

constexpr double default_size = 1.0 / 20;  ///< diameters
constexpr int max_doublings = 3;           ///< of the counts of chords whose elements are not proved valid
/// Divisions are made anew if the finished mesh misses the tolerance: their own samples are fewer. The stricter
/// tolerance of the next attempt, relative to the ratio by which the last one missed.
constexpr int max_attempts = 3;
constexpr double least_division = 0.5;  ///< of the tolerance, is left for divisions however far splines were moved
constexpr double stricter = 0.8;
/// Elongated elements are measured anew after they were made shorter.
constexpr int max_shortenings = 6;
constexpr double most_refined = 10;  ///< elements, over those without that
/// Corrections of lines from the intervals of a mesh. The last one is that which leaves more than this part of the
/// excess over the limit.
constexpr int max_line_corrections = 3;
constexpr double most_excess_left = 0.9;

SplitRequest split_request(const RefineOptions& options, const CadFace& face, Report& report) {
  const double size = options.size > 0 ? options.size : face.diameter * default_size;
  const double tolerance =
      face.diameter * (options.geometry_tol > 0 ? options.geometry_tol : default_geometry_tol(options.order));
  return {options,   options.size_field ? *options.size_field : sizing::SizeField(size),
          tolerance, {options.order, std::max(tolerance - face.fit_distance, least_division * tolerance)},
          {},        options.max_elements,
          false,     &report,
          nullptr};
}

/// With a limit on the growth, if there are walls and it is prescribed, unless only the mesh without it is valid.
SplitMesh split_smooth_or_not(const sizing::MeasuredLayout& measured, SplitRequest request,
                              const std::vector<sizing::ChordCount>& coarse) {
  request.limits_growth = !request.options.walls.empty() && request.options.target_growth > 0;
  SplitMesh smooth = split(measured, request, coarse);
  if (smooth.mesh.is_valid || !request.limits_growth) return smooth;
  request.limits_growth = false;
  SplitMesh plain = split(measured, request, coarse);
  return plain.mesh.is_valid ? std::move(plain) : std::move(smooth);
}

/// On aligned parameters, or on equal ones if only these make a valid mesh.
SplitMesh split_aligned_or_equal(const sizing::MeasuredLayout& aligned, const SplitRequest& request,
                                 const std::vector<sizing::ChordCount>& coarse) {
  SplitMesh first = split_smooth_or_not(aligned, request, coarse);
  if (first.mesh.is_valid || aligned.has_equal_parameters()) return first;
  SplitMesh equal = split_smooth_or_not(aligned.with_equal_parameters(), request, coarse);
  return equal.mesh.is_valid ? std::move(equal) : std::move(first);
}

/// Doubles the counts of all chords whose blocks need it, beyond the prescribed sizes: a block whose exact map is valid
/// has valid elements once these are small.
void double_until_valid(const sizing::MeasuredLayout& aligned, const SplitRequest& request,
                        std::vector<sizing::ChordCount> counts, SplitMesh& result) {
  for (int doublings = 1; !result.mesh.is_valid && doublings <= max_doublings; ++doublings) {
    if (!prescribe::double_counts(aligned, result.mesh, result.divisions, request.options.counts, counts)) return;
    result = split_aligned_or_equal(aligned, request, counts);
    result.doublings = doublings;
  }
}

/// Chords outside the chosen blocks start with one element; their counts are raised until the mesh is valid.
SplitMesh split_until_valid(const sizing::MeasuredLayout& aligned, const SplitRequest& request) {
  const RefineOptions& options = request.options;
  std::vector<sizing::ChordCount> coarse;
  if (!options.blocks.empty()) coarse = prescribe::coarse_counts(aligned, options.blocks, options.counts);
  SplitMesh result = split_aligned_or_equal(aligned, request, coarse);
  while (!result.mesh.is_valid && prescribe::raise_counts(aligned, result.mesh, coarse))
    result = split_aligned_or_equal(aligned, request, coarse);
  if (!options.allow_invalid) double_until_valid(aligned, request, coarse, result);
  return result;
}

struct MeasuredSplit {
  SplitMesh split;
  mesh::BoundaryDistance distance;
};

/// With more elements where the mesh, measured by projection, leaves the CAD curves by more than the tolerance.
MeasuredSplit split_within_tolerance(const sizing::MeasuredLayout& aligned, const SplitRequest& request) {
  const double tolerance = request.tolerance;
  SplitRequest attempt = request;
  MeasuredSplit result{split_until_valid(aligned, attempt), {}};
  result.distance = mesh::boundary_distance(result.split.mesh);
  for (int i = 1; i < max_attempts && !result.distance.is_within(tolerance); ++i) {
    attempt.division.tolerance *= stricter * tolerance / result.distance.worst().distance;
    SplitMesh next = split_until_valid(aligned, attempt);
    const mesh::BoundaryDistance distance = mesh::boundary_distance(next.mesh);
    if (distance.worst().distance >= result.distance.worst().distance ||
        next.mesh.is_valid < result.split.mesh.is_valid)
      break;
    result = {std::move(next), distance};
  }
  return result;
}

/// By element: whether it lies in a block that has layers, which relaxation does not move.
std::vector<bool> elements_in_layered_blocks(const SplitMesh& split) {
  std::vector<bool> is_layered;
  if (split.walls)
    for (const int block : split.mesh.elem_block) is_layered.push_back(split.walls->has_wall(block));
  return is_layered;
}

/// By element: whether a chord that layers divide passes it. Such elements are thin on purpose, also in the blocks
/// behind the layers, through which the chord runs on.
std::vector<bool> elements_on_layered_chords(const BlockLayout& blocks, const SplitMesh& split) {
  std::vector<bool> is_layered;
  if (!split.walls) return is_layered;
  for (const int block : split.mesh.elem_block) {
    const auto& arcs = blocks.block2arcs[block];
    is_layered.push_back(split.walls->is_graded[arcs[0].arc] || split.walls->is_graded[arcs[1].arc]);
  }
  return is_layered;
}

/// Of the elements that are not thin because of layers.
double worst_edge_ratio(const BlockLayout& blocks, const SplitMesh& split) {
  const std::vector<bool> is_layered = elements_on_layered_chords(blocks, split);
  double worst = 1;
  for (int e = 0; e < split.mesh.num_elems(); ++e)
    if (is_layered.empty() || !is_layered[e]) worst = std::max(worst, split.mesh.elem_edge_ratio[e]);
  return worst;
}

/// With shorter elements where blocks are thin: the best of several attempts, each of which corrects the last.
MeasuredSplit split_without_elongation(const sizing::MeasuredLayout& aligned, SplitRequest request) {
  const Progress::Part part(request.report->progress(), "attempt");
  request.attempt = &part;
  const auto measured_split = [&] {
    MeasuredSplit result = split_within_tolerance(aligned, request);
    mesh::measure_element_sizes(result.split.mesh);
    return result;
  };
  const auto edge_ratio = [&](const SplitMesh& split) { return worst_edge_ratio(aligned.blocks(), split); };
  const double target = request.options.target_edge_ratio;
  MeasuredSplit best = measured_split();
  std::optional<MeasuredSplit> worse;  // the last attempt, if it is not the best one
  const double most_elems = most_refined * best.split.mesh.num_elems();
  request.max_elements = static_cast<int>(std::min<double>(request.max_elements, most_elems));
  for (int i = 0; target > 0 && i < max_shortenings; ++i) {
    const SplitMesh& last = worse ? worse->split : best.split;
    if (!sizing::add_length_limits(aligned, last.divisions, last.mesh, request.sizes, target,
                                   elements_on_layered_chords(aligned.blocks(), last), request.limits))
      break;
    request.last = &last;
    std::optional<MeasuredSplit> next = sizing::unless_too_many(measured_split);
    if (!next) break;
    const QuadMesh& mesh = next->split.mesh;
    if (mesh.is_valid < best.split.mesh.is_valid || mesh.num_elems() > most_elems) break;
    // Prescribed counts, for instance, leave nothing to change.
    if (mesh.num_elems() == last.mesh.num_elems() && edge_ratio(next->split) == edge_ratio(last)) break;
    if (edge_ratio(next->split) < edge_ratio(best.split)) {
      best = std::move(*next);
      worse.reset();
    } else {
      worse = std::move(next);
    }
  }
  return best;
}

/// Corrects the lines inside blocks again, from the intervals that the mesh has, as long as that reduces the excess
/// over the limit and keeps the shapes of the elements.
void correct_lines(const sizing::MeasuredLayout& measured, const SplitRequest& request, SplitMesh& result) {
  const double limit = request.options.target_growth;
  double before = 0, excess = mesh::edge_growth(result.mesh, limit).excess;
  for (int i = 0; i < max_line_corrections && excess > 0 && (i == 0 || excess < most_excess_left * before); ++i) {
    SplitMesh next = result;
    growth::correct_factors(measured, *next.walls, next.divisions, result.mesh, limit, next.lines);
    next.mesh = measured_mesh(measured, request, next, &result.mesh);
    before = excess;
    excess = mesh::edge_growth(next.mesh, limit).excess;
    if (excess >= before || !next.mesh.is_valid ||
        !growth::keeps_qualities(growth::block_qualities(result.mesh), next.mesh))
      break;
    result = std::move(next);
  }
}

/// With lines along the normals of walls that are less oblique to the layers, in blocks that gain by it.
std::optional<SplitMesh> straightened(const sizing::MeasuredLayout& measured, const SplitRequest& request,
                                      const SplitMesh& split) {
  SplitMesh result = split;
  std::vector<mesh::RowShifts>& shifts = result.lines.shifts;
  shifts =
      growth::block_shifts(measured.blocks(), *split.walls, split.divisions, split.mesh, request.options.target_growth);
  while (!std::ranges::all_of(shifts, &mesh::RowShifts::empty)) {
    result.mesh = measured_mesh(measured, request, result, &split.mesh);
    if (!growth::drop_useless(split.mesh, result.mesh, shifts)) return result;
  }
  return {};
}

/// Improves the lines inside blocks of a mesh with layers. `aligned`: from which the attempts were made.
void finish_lines(const sizing::MeasuredLayout& aligned, const SplitRequest& request, SplitMesh& result) {
  if (!result.growth) return;
  const sizing::MeasuredLayout measured = result.has_equal_parameters ? aligned.with_equal_parameters() : aligned;
  std::optional<SplitMesh> straight = straightened(measured, request, result);
  if (straight) correct_lines(measured, request, *straight);
  const auto is_straight_better = [&] {
    return straight && growth::is_better(straight->mesh, result.mesh, request.options.target_growth);
  };
  if (!is_straight_better()) correct_lines(measured, request, result);
  if (is_straight_better()) result = std::move(*straight);
  mesh::measure_element_sizes(result.mesh);
}

/// The parts of an element are the same map: the distance from the CAD curves does not change.
void refine_nested(QuadMesh& mesh, const RefineOptions& options, Report& report) {
  if (options.levels == 0) return;
  sizing::require_nested_within(mesh.num_elems(), options.levels, {options.max_elements, options.order});
  mesh = mesh::nested_quads(mesh, options.levels);
  measure_elements(mesh, report.progress());
  mesh::measure_element_sizes(mesh);
}

/// Of the chords with the layers along walls, if boundaries share out their numbers.
std::vector<prescribe::LayeredCount> layered_counts(const sizing::MeasuredLayout& measured, const SplitRequest& request,
                                                    const RefineOptions& options) {
  if (options.walls.empty() || options.boundary_counts.empty()) return {};
  const bool limits_growth = options.target_growth > 0;
  const auto [order, tolerance] = request.division;
  return layers::layered_counts(
      {measured, options.walls, request.sizes, order, tolerance, limits_growth, options.counts},
      sizing::grade_chords(measured, request.sizes, options.size_rule, options.counts));
}

}  // namespace

QuadMesh refine(const BlockLayout& layout, const RefineOptions& prescribed, Report& report) {
  prescribed.validate();
  require_periodic_arcs(layout, "make the blocks again (separatrix, blocksplit)");
  const sizing::MeasuredLayout measured(layout);
  RefineOptions options = prescribed;
  const SplitRequest request = split_request(options, layout.face, report);
  const std::vector<prescribe::LayeredCount> layered = layered_counts(measured, request, options);
  options.counts = prescribe::with_boundary_counts(measured, request.sizes, options.counts, options.boundary_counts,
                                                   layered, options.end_gradings, options.end_growth);
  const sizing::MeasuredLayout aligned = measured.with_parameters(align_chords(measured));
  auto [split, distance] = split_without_elongation(aligned, request);
  finish_lines(aligned, request, split);
  if (options.relax > 0) {
    relax_and_report(split.mesh,
                     {options.relax, request.division.tolerance, elements_in_layered_blocks(split), report.progress()},
                     report);
    mesh::measure_element_sizes(split.mesh);
    distance = mesh::boundary_distance(split.mesh);
  }
  refine_nested(split.mesh, options, report);
  report.set("count_doublings", split.doublings);
  report.set("shortened_chords", split.shortened_chords);
  report.set("chords", measured.chords().size());
  report_mesh(split.mesh, report);
  mesh::report_distance(distance, layout.face, request.tolerance, report);
  if (split.walls) layers::report_walls(*split.walls, options.walls, report);
  if (split.walls && options.target_growth > 0)
    growth::report_growth(split.growth, split.lines, split.mesh, options.target_growth, report);
  sizing::report_sizes(measured, split.divisions, request.sizes, prescribed.counts, report);
  prescribe::report_boundary_counts(measured, split.divisions, options.boundary_counts, layered, report);
  prescribe::report_end_gradings(measured, split.divisions, options.end_gradings, options.end_growth, options.counts,
                                 report);
  if (!options.allow_invalid) require_valid_elements(split.mesh);
  require_quality(split.mesh, options.min_scaled_jacobian, options.max_edge_ratio);
  if (!split.mesh.is_valid) report.warn(warning::mesh_not_valid, check::validity_warning(split.mesh));
  return std::move(split.mesh);
}

}  // namespace quadrille::refine
