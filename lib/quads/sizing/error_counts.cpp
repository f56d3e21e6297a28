#include "sizing/error_counts.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace quadrille::sizing {
namespace {

constexpr int q = mesh::resolution_power;
constexpr double num_slack = 0.1;   ///< of ln N, that counts may miss
constexpr double num_weight = 40;   ///< of what they miss beyond, over a part of E N^q
constexpr double most_cost = 0.5;   ///< estimated: of the steps above it one in thirty lowered the cost, by little
constexpr double same_part = 1e-3;  ///< by which mirror images differ: vertices are relaxed to less

/// Chords that get one count, and their blocks.
struct Orbit {
  std::vector<int> chords, blocks;
};

/// Of the free chords, by their parts and counts, whatever their numbers are. Chords that are equal by chance lose a
/// choice, no more.
std::vector<Orbit> orbits_of(const ErrorParts& of) {
  std::vector<int> chords;
  for (int c = 0; c < std::ssize(of.counts); ++c)
    if (!of.is_fixed[c]) chords.push_back(c);
  std::ranges::sort(chords, [&](int a, int b) {
    return std::tie(of.counts[a], of.parts[a], a) < std::tie(of.counts[b], of.parts[b], b);
  });
  std::vector<Orbit> orbits;
  for (const int c : chords) {
    const auto is_image = [&](const Orbit& orbit) {
      const int first = orbit.chords[0];
      return of.counts[first] == of.counts[c] && of.parts[c] - of.parts[first] <= same_part * of.parts[c];
    };
    const auto found = std::ranges::find_if(orbits, is_image);
    (found == orbits.end() ? orbits.emplace_back() : *found).chords.push_back(c);
  }
  for (Orbit& orbit : orbits)
    for (int block = 0; block < std::ssize(of.block_chords); ++block)
      if (std::ranges::any_of(of.block_chords[block], [&](int c) { return std::ranges::count(orbit.chords, c) > 0; }))
        orbit.blocks.push_back(block);
  return orbits;
}

/// Counts, with the estimated sum and the number of elements.
class Counts {
 public:
  explicit Counts(const ErrorParts& of) : of_(&of), counts_(of.counts), num_(num_elements(of, of.counts)) {
    for (std::size_t c = 0; c < counts_.size(); ++c) sum_ += part(c);
  }

  const std::vector<int>& counts() const { return counts_; }
  bool is_within() const { return missed() <= 0; }
  double cost() const { return q * std::log(sum_ * num_) + num_weight * std::max(0.0, missed()); }

  /// With other counts of an orbit.
  Counts with(const Orbit& orbit, const std::vector<int>& counts) const {
    Counts result = *this;
    for (const int block : orbit.blocks) result.num_ -= num_in(block);
    for (std::size_t i = 0; i < orbit.chords.size(); ++i) {
      const int c = orbit.chords[i];
      result.counts_[c] = counts[i];
      result.sum_ += result.part(c) - part(c);
    }
    for (const int block : orbit.blocks) result.num_ += result.num_in(block);
    return result;
  }

 private:
  double missed() const { return std::abs(std::log(num_ / of_->num_elems)) - num_slack; }
  double part(std::size_t c) const {
    const double ratio = static_cast<double>(of_->counts[c]) / counts_[c];
    return of_->parts[c] * ratio * ratio;
  }
  double num_in(int block) const {
    const auto [a, b] = of_->block_chords[block];
    return static_cast<double>(counts_[a]) * counts_[b];
  }

  const ErrorParts* of_;
  std::vector<int> counts_;
  double sum_ = 0, num_ = 0;
};

struct OrbitStep {
  const Orbit* orbit;
  int direction;
  std::vector<int> counts;  ///< by chord of the orbit
};

std::vector<OrbitStep> orbit_steps(const ErrorParts& of, const std::vector<Orbit>& orbits,
                                   const AchievedCount& achieved, double part) {
  std::vector<OrbitStep> steps;
  for (const Orbit& orbit : orbits)
    for (const int direction : {-1, 1}) {
      OrbitStep step{&orbit, direction, {}};
      const int count = of.counts[orbit.chords[0]];
      const int change = std::max(1, static_cast<int>(std::lround(part * count)));
      for (const int c : orbit.chords) step.counts.push_back(achieved(c, std::max(1, count + direction * change)));
      if (direction * (step.counts[0] - count) > 0) steps.push_back(std::move(step));
    }
  return steps;
}

/// The step, with the opposite one of another chord if it would miss N.
Counts balanced(const Counts& now, const OrbitStep& step, const std::vector<OrbitStep>& all) {
  const Counts alone = now.with(*step.orbit, step.counts);
  Counts best = alone;
  if (alone.is_within()) return best;
  for (const OrbitStep& other : all) {
    if (other.orbit == step.orbit || other.direction == step.direction) continue;
    Counts both = alone.with(*other.orbit, other.counts);
    if (both.cost() < best.cost()) best = std::move(both);
  }
  return best;
}

}  // namespace

ErrorParts error_parts(const MeasuredLayout& measured, std::vector<int> counts, const QuadMesh& mesh,
                       const std::vector<std::array<double, 2>>& parts) {
  ErrorParts of;
  of.counts = std::move(counts);
  of.parts.resize(of.counts.size());
  of.is_fixed.resize(of.counts.size(), false);
  std::vector<bool> has_part(measured.blocks().num_blocks(), false);
  double sum = 0;
  for (int elem = 0; elem < mesh.num_elems(); ++elem)
    for (const int direction : {0, 1}) {
      of.parts[measured.chord_along(mesh.elem_block[elem], direction)] += parts[elem][direction];
      sum += parts[elem][direction];
      if (parts[elem][direction] > 0) has_part[mesh.elem_block[elem]] = true;
    }
  if (sum > 0)
    for (double& part : of.parts) part /= sum;
  for (int block = 0; block < std::ssize(has_part); ++block)
    if (has_part[block]) of.block_chords.push_back({measured.chord_along(block, 0), measured.chord_along(block, 1)});
  of.num_elems = num_elements(of, of.counts);
  return of;
}

double num_elements(const ErrorParts& of, const std::vector<int>& counts) {
  double num = 0;
  for (const auto [a, b] : of.block_chords) num += static_cast<double>(counts[a]) * counts[b];
  return num;
}

std::vector<CountStep> count_steps(const ErrorParts& of, const AchievedCount& achieved, double part) {
  const std::vector<Orbit> orbits = orbits_of(of);
  const std::vector<OrbitStep> all = orbit_steps(of, orbits, achieved, part);
  const Counts now(of);
  std::vector<CountStep> steps;
  for (const OrbitStep& step : all)
    if (const Counts next = balanced(now, step, all); next.is_within() && next.cost() <= now.cost() + most_cost)
      steps.push_back({step.orbit->chords[0], step.direction, next.cost() - now.cost(), next.counts()});
  std::ranges::stable_sort(steps, {}, &CountStep::cost);
  return steps;
}

}  // namespace quadrille::sizing
