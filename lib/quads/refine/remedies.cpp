#include "refine/remedies.hpp"

#include <algorithm>
#include <array>

#include "refine/chosen_blocks.hpp"

namespace quadrille::refine {
namespace {

constexpr int max_doublings = 3;  ///< of the counts of chords: 64 times as many elements in their blocks
constexpr double stricter = 0.8;  ///< than the ratio by which the boundary misses its tolerance
constexpr int most_refined = 10;  ///< elements with shorter ones, over those without

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

bool shorten_elements(const SplitRequest& request, const SplitMesh& last, SplitSettings& settings) {
  if (last.score.elongation == 0) return false;
  if (settings.length_limits.empty())
    settings.max_elements = std::min(settings.max_elements, most_refined * last.mesh.num_elems());
  return add_length_limits(layout_of(request, last.settings), last.plans, last.divisions, last.mesh, request.sizes,
                           request.limits.edge_ratio, elements_on_layered_chords(request.equal.blocks(), last),
                           settings.length_limits);
}

constexpr std::array<Remedy, 6> all_remedies{lift_growth_limit, use_equal_fractions,  raise_coarse_counts,
                                             double_all_counts, divide_more_strictly, shorten_elements};

}  // namespace

std::span<const Remedy> remedies() { return all_remedies; }

}  // namespace quadrille::refine
