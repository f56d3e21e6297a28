#include "refine/lower_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "mesh/element_sizes.hpp"
#include "refine/best_split.hpp"
#include "refine/divide_arcs.hpp"
#include "refine/joint_vertices.hpp"
#include "sizing/element_limit.hpp"
#include "sizing/error_counts.hpp"

namespace quadrille::refine {
namespace {

constexpr double good_resolution = 1.5;  ///< a quarter more error than equal squares at most
constexpr int max_rounds = 6;
constexpr int max_tried = 8'000;       ///< elements of all meshes that are tried, after which there is no other one
constexpr double skewness_weight = 2;  ///< over ln R, of ln (0.7 / least scaled Jacobian) of blocks
constexpr double worthwhile = 0.95;    ///< of the resolution ratio: less is not worth another mesh

/// How counts change the error: the second is true of more layouts, the first changes more.
struct Estimate {
  double exponent, greatest_factor;
};
constexpr std::array<Estimate, 4> estimates{{{1.0 / 8, 1.5}, {2, 1.5}, {1.0 / 8, 1}, {2, 1}}};

void fix_chords(const SplitRequest& request, const SplitMesh& split, sizing::ErrorParts& of) {
  const RefineOptions& options = request.options;
  std::vector<sizing::ChordCount> counts = options.counts;
  counts.insert(counts.end(), split.settings.counts.begin(), split.settings.counts.end());
  const growth::KeptChords kept = growth::kept_chords(request.equal, counts, options.end_gradings);
  const std::vector<mesh::Chord>& chords = request.equal.chords();
  for (std::size_t c = 0; c < chords.size(); ++c) {
    const bool has_layers = split.walls && split.walls->is_graded[chords[c].arcs[0]];
    const bool is_limited = !split.settings.length_limits.empty() && !split.settings.length_limits[c].empty();
    of.is_fixed[c] = kept.counts[c] || kept.divisions[c] || has_layers || is_limited || of.parts[c] == 0;
  }
}

/// By chord: rings with room keep the rows that they begin with. The error is that of a solution that is as smooth
/// around the hole as elsewhere, which does not need them.
std::vector<int> least_counts(const SplitRequest& request, const SplitMesh& split) {
  std::vector<int> counts(split.plans.size(), 1);
  for (const sizing::HoleRing& ring : request.rings)
    if (ring.has_room) counts[ring.chord] = split.divisions[request.equal.chords()[ring.chord].arcs[0]].num_intervals();
  return counts;
}

/// The counts that chords get where others are asked for, found by dividing their arcs.
class AchievedCounts {
 public:
  AchievedCounts(const SplitRequest& request, const SplitMesh& split, const std::vector<int>& least)
      : measured_(layout_of(request, split.settings)),
        plans_(split.plans),
        least_(least),
        options_{request.options.order, split.settings.tolerance} {}

  int operator()(int chord, int count) {
    count = std::max(count, least_[chord]);
    const auto [found, is_new] = known_.try_emplace({chord, count}, 0);
    if (is_new) {
      sizing::ChordPlan plan = plans_[chord];
      plan.count = count;
      plan.is_prescribed = true;
      plan.is_by_user = false;
      found->second = divided_count(measured_, chord, plan, options_);
    }
    return found->second;
  }

 private:
  const sizing::MeasuredLayout& measured_;
  const std::vector<sizing::ChordPlan>& plans_;
  const std::vector<int>& least_;
  DivideOptions options_;
  std::map<std::pair<int, int>, int> known_;
};

/// The same mesh with other counts, placed; no value if it would have too many elements.
std::optional<SplitMesh> split_again(const SplitRequest& request, const SplitMesh& split, const sizing::ErrorParts& of,
                                     const std::vector<int>& counts) {
  SplitSettings settings = split.settings;
  for (std::size_t c = 0; c < counts.size(); ++c)
    if (!of.is_fixed[c]) settings.counts.push_back({static_cast<int>(c), counts[c]});
  try {
    SplitMesh next = refine::split(request, settings, &split);
    place_vertices(request, next);
    set_prescribed_lengths(request, next);
    next.settings.counts = split.settings.counts;
    return next;
  } catch (const sizing::TooManyElements&) {
    return std::nullopt;
  }
}

/// `resolution`: the ratio of `next` over that of `split`.
bool is_better(const SplitMesh& next, const SplitMesh& split, double resolution) {
  const mesh::MeshScore &before = split.score, &after = next.score;
  return joints_inside_edges(next.mesh).size() <= joints_inside_edges(split.mesh).size() &&
         after.unproved <= before.unproved && !mesh::exceeds(after.distance, before.distance) &&
         !mesh::exceeds(after.elongation, before.elongation) && after.growth <= before.growth &&
         std::log(resolution) + skewness_weight * (after.skewness - before.skewness) < std::log(worthwhile);
}

}  // namespace

void lower_error(const SplitRequest& request, SplitMesh& result) {
  const std::vector<int> least = least_counts(request, result);
  double num_elems = 0;  // of the first mesh, that sizes and breaks mean
  std::size_t estimate = 0;
  std::set<std::vector<int>> tried;
  int num_tried = 0;
  const auto resolution_of = [&](const QuadMesh& mesh) {
    return mesh::resolution(mesh, sizing::ring_lengths(mesh, request.rings));
  };
  mesh::Resolution resolution = resolution_of(result.mesh);
  for (int round = 0; round < max_rounds && num_tried < max_tried && estimate < estimates.size(); ++round) {
    if (resolution.ratio <= good_resolution) return;
    sizing::ErrorParts of = sizing::error_parts(request.equal, result.divisions, result.mesh, resolution);
    if (round == 0) num_elems = of.num_elems;
    of.num_elems = num_elems;
    of.exponent = estimates[estimate].exponent;
    of.greatest_factor = estimates[estimate].greatest_factor;
    fix_chords(request, result, of);
    AchievedCounts achieved(request, result, least);
    const sizing::ErrorCounts counts = sizing::least_error_counts(of, std::ref(achieved));
    std::optional<SplitMesh> next;
    if (counts.ratio < worthwhile && tried.insert(counts.counts).second)
      next = split_again(request, result, of, counts.counts);
    if (next) num_tried += next->mesh.num_elems();
    mesh::Resolution of_next = next ? resolution_of(next->mesh) : resolution;
    if (next && is_better(*next, result, of_next.ratio / resolution.ratio)) {
      result = std::move(*next);
      resolution = std::move(of_next);
    } else {
      ++estimate;
    }
  }
}

}  // namespace quadrille::refine
