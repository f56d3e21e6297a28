#include "refine/best_split.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>

#include "growth/straighten_lines.hpp"
#include "refine/chosen_blocks.hpp"
#include "refine/inner_edges.hpp"
#include "refine/relax_sizes.hpp"
#include "sizing/element_limit.hpp"

namespace quadrille::refine {
namespace {

constexpr int max_doublings = 3;  ///< of the counts of chords: 64 times as many elements in their blocks
constexpr double stricter = 0.8;  ///< than the ratio by which the boundary misses its tolerance
/// Elements with shorter ones, over those without, when vertices are where they stay.
constexpr int most_refined = 10;
/// The same before vertices move, for sizes make most elements shorter then, and where they do not, beside short edges.
constexpr int least_refined = 2;

bool moves_vertices(const RefineOptions& options) { return options.relax != Relax::none && options.blocks.empty(); }

void restore_lines(const SplitRequest& request, SplitSettings& settings) {
  const SplitSettings first = first_settings(request);
  settings.limits_growth = first.limits_growth;
  settings.is_aligned = first.is_aligned;
}

bool lift_growth_limit(const SplitRequest&, const SplitMesh& last, SplitSettings& settings) {
  if (last.mesh.is_valid || !settings.limits_growth) return false;
  settings.limits_growth = false;
  return true;
}

bool use_equal_fractions(const SplitRequest& request, const SplitMesh& last, SplitSettings& settings) {
  if (last.mesh.is_valid || !settings.is_aligned) return false;
  restore_lines(request, settings);
  settings.is_aligned = false;
  return true;
}

bool raise_coarse_counts(const SplitRequest& request, const SplitMesh& last, SplitSettings& settings) {
  if (last.mesh.is_valid || settings.doublings > 0 || !raise_counts(request.equal, last.mesh, settings.counts))
    return false;
  restore_lines(request, settings);
  return true;
}

/// A block whose exact map is valid has valid elements once these are small.
bool double_all_counts(const SplitRequest& request, const SplitMesh& last, SplitSettings& settings) {
  const RefineOptions& options = request.options;
  if (last.mesh.is_valid || options.allow_invalid || settings.doublings == max_doublings ||
      !double_counts(request.equal, last.mesh, last.divisions, options.counts, settings.counts))
    return false;
  ++settings.doublings;
  restore_lines(request, settings);
  return true;
}

/// What splines that were replaced add to the distance does not change.
bool divide_more_strictly(const SplitRequest& request, const SplitMesh& last, SplitSettings& settings) {
  const double fit = last.mesh.face.fit_distance, allowed = request.limits.distance - fit;
  if (last.score.distance == 0 || allowed <= 0) return false;
  settings.tolerance *= stricter * allowed / (last.distance.worst().distance - fit);
  return true;
}

/// `shortest`: as add_length_limits has it.
bool shorten(const SplitRequest& request, const SplitMesh& last, double shortest, SplitSettings& settings) {
  return add_length_limits(layout_of(request, last.settings), last.plans, last.divisions, last.mesh, request.sizes,
                           request.limits.edge_ratio, shortest,
                           elements_on_layered_chords(request.equal.blocks(), last), settings.length_limits);
}

bool shorten_elements(const SplitRequest& request, const SplitMesh& last, SplitSettings& settings) {
  if (last.score.elongation == 0) return false;
  const int most = moves_vertices(request.options) ? least_refined : most_refined;
  if (settings.length_limits.empty())
    settings.max_elements = std::min(settings.max_elements, most * last.mesh.num_elems());
  return shorten(request, last, shortest_kept_edge(layout_of(request, last.settings)), settings);
}

/// No value if it would have too many elements.
std::optional<SplitMesh> next_attempt(const SplitRequest& request, const SplitSettings& settings,
                                      const SplitMesh& last) {
  try {
    return split(request, settings, &last);
  } catch (const sizing::TooManyElements&) {
    return std::nullopt;
  }
}

constexpr std::array<Remedy, 6> all_remedies{lift_growth_limit, use_equal_fractions,  raise_coarse_counts,
                                             double_all_counts, divide_more_strictly, shorten_elements};

constexpr int max_corrections = 3;

/// Keeps a mesh with other lines if it is better; returns whether it is.
bool keep_if_better(const SplitRequest& request, SplitMesh next, SplitMesh& result) {
  set_score(request, next);
  const bool is_better = mesh::is_better(next.score, result.score);
  if (is_better) result = std::move(next);
  return is_better;
}

void straighten_lines(const SplitRequest& request, SplitMesh& result) {
  SplitMesh next = result;
  std::vector<layers::RowShifts>& shifts = next.lines.shifts;
  shifts =
      growth::block_shifts(request.equal.blocks(), *result.walls, result.divisions, result.mesh, request.limits.growth);
  while (!std::ranges::all_of(shifts, &layers::RowShifts::empty)) {
    sample_mesh(request, &result.mesh, next);
    if (growth::drop_useless(result.mesh, next.mesh, shifts)) continue;
    keep_if_better(request, std::move(next), result);
    return;
  }
}

/// Returns whether this improves the mesh.
bool correct_lines(const SplitRequest& request, SplitMesh& result) {
  if (result.score.growth == 0) return false;
  SplitMesh next = result;
  growth::correct_factors(layout_of(request, result.settings), *result.walls, result.divisions, result.mesh,
                          request.limits.growth, next.lines);
  sample_mesh(request, &result.mesh, next);
  return keep_if_better(request, std::move(next), result);
}

/// By element: whether its chords have layers or prescribed lengths at their ends, from which elements grow.
std::vector<bool> elements_that_keep_lengths(const SplitRequest& request, const SplitMesh& split) {
  const BlockLayout& blocks = request.equal.blocks();
  std::vector<bool> keeps = elements_on_layered_chords(blocks, split);
  keeps.resize(split.mesh.num_elems(), false);
  const std::vector<bool> divisions = growth::kept_chords(request.equal, {}, request.options.end_gradings).divisions;
  for (int elem = 0; elem < split.mesh.num_elems(); ++elem)
    for (const int side : {0, 1})
      if (divisions[blocks.arc_chord[blocks.block2arcs[split.mesh.elem_block[elem]][side].arc]]) keeps[elem] = true;
  return keeps;
}

/// Returns whether the relaxed mesh is taken: not if no vertex was moved, or it would exceed what is allowed by more.
/// Edges are relaxed further with a stricter tolerance if they miss it between the samples of that time.
bool take_relaxed(const SplitRequest& request, double least_progress, SizeRelaxed relaxed, SplitMesh& result) {
  if (relaxed.sweeps == 0) return false;
  mesh::BoundaryDistance distance = mesh::boundary_distance(relaxed.mesh);
  for (int round = 0; round < max_corrections; ++round) {
    if (distance.is_within(std::max(request.limits.distance, result.distance.worst().distance))) break;
    relaxed.relaxation->tighten(stricter * request.limits.distance / distance.worst().distance);
    if (!relaxed.relaxation->run(least_progress, relaxed)) break;
    distance = mesh::boundary_distance(relaxed.mesh);
  }
  SplitMesh next = result;
  next.mesh = std::move(relaxed.mesh);
  next.distance = distance;
  next.relaxation = relaxed.relaxation;
  set_score(request, next);
  const mesh::MeshScore &before = result.score, &after = next.score;
  if (after.unproved > before.unproved || mesh::exceeds(after.distance, before.distance) ||
      mesh::exceeds(after.elongation, before.elongation) || (result.walls && mesh::is_better(before, after)))
    return false;
  report_relaxation(request.report, relaxed.relaxation->before(), relaxed);
  result = std::move(next);
  return true;
}

/// Returns whether vertices were moved.
bool relax_sizes(const SplitRequest& request, double least_progress, SplitMesh& result) {
  SizeRelaxation relaxation = size_relaxation(request, result);
  relaxation.least_progress = least_progress;
  if (result.vertices) relaxation.start = &*result.vertices;
  return take_relaxed(request, least_progress, relax_to_sizes(result.mesh, relaxation), result);
}

}  // namespace

SizeRelaxation size_relaxation(const SplitRequest& request, const SplitMesh& split) {
  SizeRelaxation relaxation{request.sizes_at_bends,
                            request.options.inner_edges,
                            split.settings.tolerance,
                            request.options.relax_sweeps,
                            elements_that_keep_lengths(request, split),
                            elements_on_layered_chords(request.equal.blocks(), split)};
  relaxation.keeps_lengths = request.options.relax == Relax::shape;
  relaxation.directions = request.options.directions;
  relaxation.greatest_lengths = sizing::ring_lengths(split.mesh, request.rings);
  if (!request.options.boundary_counts.empty()) relaxation.slides_off = SlidesOff::breaks;
  relaxation.even_curves = prescribe::even_curves(split.mesh.face, request.options.boundary_counts);
  return relaxation;
}

std::span<const Remedy> remedies() { return all_remedies; }

BestSplit best_split(const SplitRequest& request) {
  const Progress::Part part(request.report.progress(), "attempt");
  part.advance();
  SplitSettings settings = first_settings(request);
  BestSplit best{split(request, settings, nullptr)};
  std::optional<SplitMesh> worse;  // the last attempt, if it is not the best one
  for (; best.num_splits < max_splits; ++best.num_splits) {
    const SplitMesh& last = worse ? *worse : best.split;
    if (std::ranges::none_of(remedies(), [&](Remedy remedy) { return remedy(request, last, settings); })) break;
    part.advance();
    std::optional<SplitMesh> next = next_attempt(request, settings, last);
    if (!next) break;
    if (mesh::is_better(next->score, best.split.score)) {
      best.split = std::move(*next);
      worse.reset();
    } else {
      worse = std::move(next);
    }
  }
  return best;
}

void place_vertices(const SplitRequest& request, SplitMesh& result, double least_progress) {
  if (result.growth) {
    straighten_lines(request, result);
    for (int i = 0; i < max_corrections && correct_lines(request, result); ++i) {
    }
  }
  const RefineOptions& options = request.options;
  if (moves_vertices(options) && relax_sizes(request, least_progress, result)) return;
  shape_inner_edges(result.mesh, options.inner_edges, elements_on_layered_chords(request.equal.blocks(), result));
  result.distance = mesh::boundary_distance(result.mesh);
  set_score(request, result);
}

void place_further(const SplitRequest& request, SplitMesh& result, double least_progress) {
  if (!result.relaxation || result.relaxation->least_progress() <= least_progress) return;
  SizeRelaxed relaxed{{}, 0, 0, 0, 0, result.relaxation};
  if (result.relaxation->run(least_progress, relaxed))
    take_relaxed(request, least_progress, std::move(relaxed), result);
}

std::optional<SplitMesh> with_shorter_elements(const SplitRequest& request, const SplitMesh& placed) {
  SplitSettings settings = placed.settings;
  if (placed.score.elongation == 0 || !shorten(request, placed, std::numeric_limits<double>::infinity(), settings))
    return std::nullopt;
  const int most = moves_vertices(request.options) ? most_refined : least_refined;
  settings.max_elements = std::min(settings.max_elements, most * placed.mesh.num_elems());
  std::optional<SplitMesh> next = next_attempt(request, settings, placed);
  if (next) next->settings.max_elements = placed.settings.max_elements;
  return next;
}

}  // namespace quadrille::refine
