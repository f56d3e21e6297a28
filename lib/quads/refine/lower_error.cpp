#include "refine/lower_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "base/tolerance.hpp"
#include "mesh/element_sizes.hpp"
#include "refine/best_split.hpp"
#include "refine/count_relaxer.hpp"
#include "refine/divide_arcs.hpp"
#include "refine/joint_vertices.hpp"
#include "refine/validity.hpp"
#include "sizing/element_limit.hpp"
#include "sizing/error_counts.hpp"

namespace quadrille::refine {
namespace {

constexpr int max_rounds = 2;             ///< meshes that are made
constexpr int few_steps = 4;              ///< of a round: after fewer, trials on the mesh then made are much the same
constexpr int max_moved = 60'000;         ///< elements of all counts that are tried in a round
constexpr std::array steps{1.0 / 4, 0.};  ///< of a count, at least one element
constexpr double shape_weight = 10;       ///< over ln R, of ln of the least scaled Jacobian
constexpr double least_gain = 0.005;      ///< of the cost, by a step
constexpr double hopeless = 0.05;         ///< loss of the cost by a step that is not tried again

/// What it costs that the least scaled Jacobian falls by more than 5 %, to less than 0.7.
double shape_cost(double before, double after) {
  return shape_weight * std::max(0.0, std::log(std::min(0.95 * before, 0.7) / std::max(after, tolerance::tied)));
}

double resolution_ratio(const SplitRequest& request, const QuadMesh& mesh) {
  return mesh::resolution(mesh, sizing::ring_lengths(mesh, request.rings)).ratio;
}

/// The counts that chords get where others are asked for, found by dividing their arcs; those of the mesh stay.
class AchievedCounts {
 public:
  AchievedCounts(const SplitRequest& request, const SplitMesh& split)
      : measured_(layout_of(request, split.settings)),
        plans_(split.plans),
        options_(divide_options(request, split.settings)),
        least_(split.plans.size(), 1) {
    for (const mesh::Chord& chord : request.equal.chords())
      counts_.push_back(split.divisions[chord.arcs[0]].num_intervals());
    // Rings with room keep the rows that they begin with. The error is that of a solution that is as smooth around the
    // hole as elsewhere, which does not need them.
    for (const sizing::HoleRing& ring : request.rings)
      if (ring.has_room) least_[ring.chord] = counts_[ring.chord];
  }

  const std::vector<int>& of_mesh() const { return counts_; }

  int operator()(int chord, int count) {
    count = std::max(count, least_[chord]);
    if (count == counts_[chord]) return count;
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

  /// The least count that was asked for where a chord got this one.
  int asked(int chord, int count) const {
    const auto gives = [&](const auto& known) { return known.first.first == chord && known.second == count; };
    const auto found = std::ranges::find_if(known_, gives);
    return found == known_.end() ? count : found->first.second;
  }

 private:
  const sizing::MeasuredLayout& measured_;
  const std::vector<sizing::ChordPlan>& plans_;
  DivideOptions options_;
  std::vector<int> least_, counts_;
  std::map<std::pair<int, int>, int> known_;
};

/// The parts of the error of meshes with other counts, and what they cost.
class CountTrials {
 public:
  CountTrials(const SplitRequest& request, const SplitMesh& split, const std::vector<int>& counts)
      : request_(request),
        counts_(counts),
        ring_lengths_(sizing::ring_lengths(split.mesh, request.rings)),
        relaxer_(split.mesh, size_relaxation(request, split)) {}

  struct Trial {
    sizing::ErrorParts of;
    double cost = 0;
  };
  Trial at(const std::vector<int>& counts);
  /// The next ones begin from there.
  void keep() { relaxer_.keep(); }
  PlacedVertices kept() const { return relaxer_.kept(); }

 private:
  const SplitRequest& request_;
  std::vector<int> counts_;  ///< of the mesh
  std::vector<Vec2> ring_lengths_;
  CountRelaxer relaxer_;
  double first_jacobian_ = 0;  ///< least scaled Jacobian of the first trial
};

CountTrials::Trial CountTrials::at(const std::vector<int>& counts) {
  const std::vector<int>& elem_block = relaxer_.mesh().elem_block;
  std::vector<Vec2> factors;
  for (const int block : elem_block) {
    const auto factor = [&](int side) {
      const int chord = request_.equal.chord_along(block, side);
      return static_cast<double>(counts[chord]) / counts_[chord];
    };
    factors.push_back({factor(0), factor(1)});
  }
  const QuadMesh& mesh = relaxer_.moved(factors);
  mesh::Resolution resolution = relaxer_.resolution(request_.sizes, ring_lengths_);
  double sum = 0;
  for (std::size_t elem = 0; elem < factors.size(); ++elem) {
    auto& [along_s, along_t] = resolution.parts[elem];
    along_s *= std::pow(factors[elem].x, -2 * mesh::resolution_power);
    along_t *= std::pow(factors[elem].y, -2 * mesh::resolution_power);
    sum += along_s + along_t;
  }
  Trial trial{sizing::error_parts(request_.equal, counts, mesh, resolution.parts)};
  const double more = trial.of.num_elems / sizing::num_elements(trial.of, counts_);
  trial.cost = std::log(resolution.ratio * sum) + mesh::resolution_power * std::log(more);
  for (const double skewness : mesh::block_skewness(mesh)) trial.cost += skewness;
  const double jacobian = least_scaled_jacobian(mesh);
  if (first_jacobian_ == 0) first_jacobian_ = jacobian;
  trial.cost += shape_cost(first_jacobian_, jacobian);
  return trial;
}

/// By chord.
std::vector<bool> fixed_chords(const SplitRequest& request, const SplitMesh& split) {
  const RefineOptions& options = request.options;
  std::vector<sizing::ChordCount> counts = options.counts;
  counts.insert(counts.end(), split.settings.counts.begin(), split.settings.counts.end());
  const growth::KeptChords kept = growth::kept_chords(request.equal, counts, options.end_gradings);
  const std::vector<mesh::Chord>& chords = request.equal.chords();
  std::vector<bool> is_fixed;
  for (std::size_t c = 0; c < chords.size(); ++c) {
    const bool has_layers = split.walls && split.walls->is_graded[chords[c].arcs[0]];
    const bool is_limited = !split.settings.length_limits.empty() && !split.settings.length_limits[c].empty();
    is_fixed.push_back(kept.counts[c] || kept.divisions[c] || has_layers || is_limited);
  }
  return is_fixed;
}

/// The search for better counts.
class CountSearch {
 public:
  CountSearch(const SplitRequest& request, const SplitMesh& split, double num_elems)
      : achieved_(request, split),
        trials_(request, split, achieved_.of_mesh()),
        is_fixed_(fixed_chords(request, split)),
        num_elems_(num_elems),
        most_trials_(max_moved / std::max(1, split.mesh.num_elems())) {
    try_counts(achieved_.of_mesh());
  }
  /// N; that of the mesh, if none was given.
  double num_elems() const { return num_elems_; }

  /// What chords that get another count are asked for.
  std::vector<sizing::ChordCount> best();
  int num_trials() const { return num_trials_; }
  int num_steps() const { return num_steps_; }  ///< that were taken
  /// With the best counts.
  PlacedVertices vertices() const { return trials_.kept(); }

 private:
  /// Of a chord, and its direction.
  using Step = std::pair<int, int>;

  /// Takes counts if they are better. Returns the change of the cost.
  double try_counts(const std::vector<int>& counts);
  void descend(double part);
  bool take_step(double part, std::map<Step, double>& losses);

  AchievedCounts achieved_;
  CountTrials trials_;
  const std::vector<bool> is_fixed_;
  double num_elems_;
  const int most_trials_;
  int num_trials_ = 0, num_steps_ = 0;
  CountTrials::Trial now_;
  std::map<std::vector<int>, double> tried_;  ///< of the cost by counts that were tried since the last better ones
};

std::vector<sizing::ChordCount> CountSearch::best() {
  for (const double part : steps) descend(part);
  std::vector<sizing::ChordCount> changed;
  for (int c = 0; c < std::ssize(now_.of.counts); ++c)
    if (const int count = now_.of.counts[c]; count != achieved_.of_mesh()[c])
      changed.push_back({c, achieved_.asked(c, count)});
  return changed;
}

double CountSearch::try_counts(const std::vector<int>& counts) {
  if (const auto found = tried_.find(counts); found != tried_.end()) return found->second;
  ++num_trials_;
  const bool is_first = now_.of.counts.empty();
  CountTrials::Trial next = trials_.at(counts);
  const double change = next.cost - now_.cost;
  if (!is_first && !(change < -least_gain)) return tried_[counts] = change;
  tried_.clear();
  now_ = std::move(next);
  now_.of.is_fixed = is_fixed_;
  if (num_elems_ == 0) num_elems_ = now_.of.num_elems;
  now_.of.num_elems = num_elems_;
  trials_.keep();
  return change;
}

/// Steps that lost something since the last one that was taken come last, and those that lost much no more.
bool CountSearch::take_step(double part, std::map<Step, double>& losses) {
  std::vector<sizing::CountStep> all = sizing::count_steps(now_.of, std::ref(achieved_), part);
  const auto loss = [&](const sizing::CountStep& step) {
    const auto found = losses.find({step.chord, step.direction});
    return found == losses.end() ? 0 : found->second;
  };
  std::erase_if(all, [&](const sizing::CountStep& step) { return loss(step) > hopeless; });
  std::stable_partition(all.begin(), all.end(), [&](const sizing::CountStep& step) { return loss(step) == 0; });
  for (const sizing::CountStep& step : all) {
    if (num_trials_ >= most_trials_) return false;
    const double change = try_counts(step.counts);
    if (change < -least_gain) return ++num_steps_, losses.erase({step.chord, step.direction}), true;
    losses[{step.chord, step.direction}] = std::max(change, least_gain);
  }
  return false;
}

void CountSearch::descend(double part) {
  std::map<Step, double> losses;
  while (take_step(part, losses)) {
  }
}

/// The same mesh with other counts; no value if it would have too many elements.
std::optional<SplitMesh> split_again(const SplitRequest& request, const SplitMesh& split,
                                     const std::vector<sizing::ChordCount>& counts) {
  SplitSettings settings = split.settings;
  settings.counts.insert(settings.counts.end(), counts.begin(), counts.end());
  try {
    SplitMesh next = refine::split(request, settings, &split);
    next.settings.counts = split.settings.counts;
    return next;
  } catch (const sizing::TooManyElements&) {
    return std::nullopt;
  }
}

SplitMesh nearly_placed(const SplitRequest& request, SplitMesh mesh) {
  place_vertices(request, mesh, coarse_progress);
  set_prescribed_lengths(request, mesh);
  return mesh;
}

/// Whether `next` exceeds anything more than `split`, but for the distance from the CAD curves: drafts may miss it, and
/// place_further meets it.
bool exceeds_more(const SplitMesh& next, const SplitMesh& split) {
  const mesh::MeshScore &before = split.score, &after = next.score;
  return joints_inside_edges(next.mesh).size() > joints_inside_edges(split.mesh).size() ||
         after.unproved > before.unproved || mesh::exceeds(after.elongation, before.elongation) ||
         after.growth > before.growth;
}

/// `resolution`: the ratio of `next` over that of `split`.
bool is_better(const SplitMesh& next, const SplitMesh& split, double resolution) {
  const double shape = shape_cost(least_scaled_jacobian(split.mesh), least_scaled_jacobian(next.mesh));
  return !exceeds_more(next, split) && std::log(resolution) + next.score.skewness - split.score.skewness + shape < 0;
}

/// A mesh, and the same with its vertices nearly in place.
struct Draft {
  Draft(const SplitRequest& request, SplitMesh mesh)
      : unplaced(std::move(mesh)), near(nearly_placed(request, unplaced)) {}

  SplitMesh unplaced, near;
};

/// With better counts than the first ones, if there are any.
std::optional<Draft> better_draft(const SplitRequest& request, const Draft& first) {
  std::optional<Draft> best;
  int num_trials = 0;
  double num_elems = 0;  // of the first mesh, that sizes and breaks mean
  std::vector<sizing::ChordCount> counts;
  double ratio = resolution_ratio(request, first.near.mesh);
  for (int round = 0; round < max_rounds && ratio > request.options.good_resolution; ++round) {
    const Draft& now = best ? *best : first;
    CountSearch search(request, now.near, num_elems);
    num_elems = search.num_elems();
    const std::vector<sizing::ChordCount> changed = search.best();
    num_trials += search.num_trials();
    request.report.set("count_trials", num_trials);
    if (changed.empty()) break;
    for (const sizing::ChordCount& change : changed) {
      std::erase_if(counts, [&](const sizing::ChordCount& c) { return c.chord == change.chord; });
      counts.push_back(change);
    }
    std::optional<SplitMesh> mesh = split_again(request, now.unplaced, counts);
    if (!mesh) break;
    mesh->vertices = search.vertices();
    Draft next(request, std::move(*mesh));
    const double factor = resolution_ratio(request, next.near.mesh) / ratio;
    if (!is_better(next.near, now.near, factor)) break;
    best = std::move(next);
    ratio *= factor;
    if (search.num_steps() < few_steps) break;
  }
  return best;
}

}  // namespace

void lower_error(const SplitRequest& request, SplitMesh& result) {
  Draft first(request, std::move(result));
  if (std::optional<SplitMesh> next = with_shorter_elements(request, first.near)) {
    Draft shorter(request, std::move(*next));
    if (mesh::is_better(shorter.near.score, first.near.score)) first = std::move(shorter);
  }
  const auto placed = [&](SplitMesh near) {
    place_further(request, near, request.options.least_progress);
    set_prescribed_lengths(request, near);
    return near;
  };
  if (std::optional<Draft> better = better_draft(request, first)) {
    result = placed(std::move(better->near));
    if (!exceeds_more(result, first.near) && !mesh::exceeds(result.score.distance, first.near.score.distance)) return;
  }
  result = placed(std::move(first.near));
}

}  // namespace quadrille::refine
