#include "sizing/error_counts.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "base/tolerance.hpp"
#include "mesh/element_sizes.hpp"

namespace quadrille::sizing {
namespace {

struct CountConstants {
  int rounds = 60;          ///< of the fixed point
  double num_slack = 0.05;  ///< part of N that whole counts may miss
  double num_weight = 40;   ///< of what they miss beyond, over a part of E N^q
  double same = 1e-3;       ///< part by which mirror images differ: vertices are relaxed to less
  int whole_step = 2;
  int sweeps = 20;
};
constexpr CountConstants count_constants;
constexpr int q = mesh::resolution_power;

double num_of(const ErrorParts& of, const std::vector<double>& counts) {
  double num = 0;
  for (const auto [a, b] : of.block_chords) num += counts[a] * counts[b];
  return num;
}

int least_count(const ErrorParts& of, std::size_t c) {
  return std::max(1, std::min(of.counts[c] - 1, static_cast<int>(std::ceil(of.counts[c] / of.greatest_factor))));
}

int greatest_count(const ErrorParts& of, std::size_t c) {
  return std::max(of.counts[c] + 1, static_cast<int>(of.counts[c] * of.greatest_factor));
}

/// Real counts with N elements; none is below 1 or far from that of the mesh.
class RealCounts {
 public:
  explicit RealCounts(const ErrorParts& of) : of_(of), counts_(of.counts.begin(), of.counts.end()) {
    for (int round = 0; round < count_constants.rounds; ++round) {
      balance();
      scale_to_num();
    }
  }
  const std::vector<double>& counts() const { return counts_; }

 private:
  double bounded(std::size_t c, double count) const {
    return of_.is_fixed[c] ? of_.counts[c] : std::clamp<double>(count, least_count(of_, c), greatest_count(of_, c));
  }
  std::vector<double> scaled(double factor) const {
    std::vector<double> result;
    for (std::size_t c = 0; c < counts_.size(); ++c) result.push_back(bounded(c, factor * counts_[c]));
    return result;
  }
  /// Half a step, of logarithms, to where each chord has the same part of the sum and of the elements' directions.
  void balance() {
    const double num = num_of(of_, counts_);
    std::vector<double> others(counts_.size());
    for (const auto [a, b] : of_.block_chords) others[a] += counts_[b], others[b] += counts_[a];
    for (std::size_t c = 0; c < counts_.size(); ++c)
      if (others[c] > 0) counts_[c] = bounded(c, std::sqrt(counts_[c] * best(c, others[c] / (2 * num))));
  }
  /// Where the estimate is least if the other counts stay. `others`: their sum over the blocks of the chord, over 2 N.
  double best(std::size_t c, double others) const {
    return std::pow(of_.parts[c] * std::pow(of_.counts[c], of_.exponent) / others, 1 / (1 + of_.exponent));
  }
  void scale_to_num() {
    double low = 0.1, high = 10;
    for (int i = 0; i < 50; ++i) {
      const double middle = std::sqrt(low * high);
      (num_of(of_, scaled(middle)) < of_.num_elems ? low : high) = middle;
    }
    counts_ = scaled(high);
  }

  const ErrorParts& of_;
  std::vector<double> counts_;
};

/// Chords that get one count, and their blocks.
struct Orbit {
  std::vector<int> chords, blocks;
};

/// Of the free chords, by their parts, counts and real counts, whatever their numbers are. Chords that are equal by
/// chance lose a choice, no more.
std::vector<Orbit> orbits_of(const ErrorParts& of, const std::vector<double>& real) {
  std::vector<int> chords;
  for (int c = 0; c < std::ssize(of.counts); ++c)
    if (!of.is_fixed[c]) chords.push_back(c);
  std::ranges::sort(chords, [&](int a, int b) {
    return std::tie(real[a], of.counts[a], of.parts[a], a) < std::tie(real[b], of.counts[b], of.parts[b], b);
  });
  const auto is_same = [&](double a, double b) { return std::abs(a - b) <= count_constants.same * std::max(a, b); };
  std::vector<Orbit> orbits;
  for (const int c : chords) {
    const auto is_image = [&](const Orbit& orbit) {
      const int first = orbit.chords[0];
      return is_same(real[first], real[c]) && is_same(of.parts[first], of.parts[c]) && of.counts[first] == of.counts[c];
    };
    const auto found = std::ranges::find_if(orbits, is_image);
    (found == orbits.end() ? orbits.emplace_back() : *found).chords.push_back(c);
  }
  for (Orbit& orbit : orbits)
    for (int block = 0; block < std::ssize(of.block_chords); ++block)
      for (const int c : orbit.chords)
        if (const auto [a, b] = of.block_chords[block];
            (a == c || b == c) && (orbit.blocks.empty() || orbit.blocks.back() != block))
          orbit.blocks.push_back(block);
  return orbits;
}

/// Whole counts, with the sum and the number of elements.
class WholeCounts {
 public:
  WholeCounts(const ErrorParts& of, std::vector<int> counts) : of_(of), counts_(std::move(counts)) {
    for (std::size_t c = 0; c < counts_.size(); ++c) sum_ += part(c);
    for (const auto [a, b] : of_.block_chords) num_ += static_cast<double>(counts_[a]) * counts_[b];
  }

  const std::vector<int>& counts() const { return counts_; }
  double log_error() const { return 2 * q / of_.exponent * std::log(sum_) + q * std::log(num_); }

  double cost() const {
    const double missed = std::abs(std::log(num_ / of_.num_elems));
    return log_error() + count_constants.num_weight * std::max(0.0, missed - count_constants.num_slack);
  }

  /// Sets the counts of an orbit if that is better.
  bool change(const Orbit& orbit, const std::vector<int>& counts) {
    const double cost_before = cost(), sum_before = sum_, num_before = num_;
    std::vector<int> counts_before;
    for (const int block : orbit.blocks) num_ -= num_in(block);
    for (std::size_t i = 0; i < orbit.chords.size(); ++i) {
      const int c = orbit.chords[i];
      sum_ -= part(c);
      counts_before.push_back(std::exchange(counts_[c], counts[i]));
      sum_ += part(c);
    }
    for (const int block : orbit.blocks) num_ += num_in(block);
    if (cost() < cost_before - tolerance::tied) return true;
    for (std::size_t i = 0; i < orbit.chords.size(); ++i) counts_[orbit.chords[i]] = counts_before[i];
    sum_ = sum_before, num_ = num_before;
    return false;
  }

 private:
  double part(std::size_t c) const {
    const double ratio = static_cast<double>(of_.counts[c]) / counts_[c];
    return of_.parts[c] * std::pow(ratio, of_.exponent);
  }
  double num_in(int block) const {
    const auto [a, b] = of_.block_chords[block];
    return static_cast<double>(counts_[a]) * counts_[b];
  }

  const ErrorParts& of_;
  std::vector<int> counts_;
  double sum_ = 0, num_ = 0;
};

bool improve(const ErrorParts& of, const Orbit& orbit, const AchievedCount& achieved, WholeCounts& whole) {
  bool is_any = false;
  for (int step = -count_constants.whole_step; step <= count_constants.whole_step; ++step) {
    std::vector<int> counts;
    bool is_within = step != 0;
    for (const int c : orbit.chords) {
      counts.push_back(achieved(c, std::max(1, whole.counts()[c] + step)));
      is_within &= counts.back() >= least_count(of, c) && counts.back() <= greatest_count(of, c);
    }
    if (is_within && whole.change(orbit, counts)) is_any = true;
  }
  return is_any;
}

WholeCounts descend(const ErrorParts& of, const std::vector<Orbit>& orbits, const AchievedCount& achieved,
                    std::vector<int> counts) {
  WholeCounts whole(of, std::move(counts));
  bool is_better = true;
  for (int sweep = 0; is_better && sweep < count_constants.sweeps; ++sweep) {
    is_better = false;
    for (const Orbit& orbit : orbits) is_better |= improve(of, orbit, achieved, whole);
  }
  return whole;
}

}  // namespace

ErrorParts error_parts(const MeasuredLayout& measured, const ArcDivisions& divisions, const QuadMesh& mesh,
                       const mesh::Resolution& resolution) {
  ErrorParts of;
  for (const mesh::Chord& chord : measured.chords()) of.counts.push_back(divisions[chord.arcs[0]].num_intervals());
  of.parts.resize(of.counts.size());
  of.is_fixed.resize(of.counts.size(), false);
  std::vector<bool> counts(measured.blocks().num_blocks(), false);
  const auto chord_along = [&](int block, int side) {
    return measured.chord_of(measured.blocks().block2arcs[block][side].arc);
  };
  for (int elem = 0; elem < mesh.num_elems(); ++elem)
    for (const int direction : {0, 1}) {
      of.parts[chord_along(mesh.elem_block[elem], direction)] += resolution.parts[elem][direction];
      if (resolution.parts[elem][direction] > 0) counts[mesh.elem_block[elem]] = true;
    }
  for (int block = 0; block < std::ssize(counts); ++block)
    if (counts[block]) of.block_chords.push_back({chord_along(block, 0), chord_along(block, 1)});
  of.num_elems = num_of(of, {of.counts.begin(), of.counts.end()});
  return of;
}

ErrorCounts least_error_counts(const ErrorParts& of, const AchievedCount& achieved) {
  const std::vector<double> real = RealCounts(of).counts();
  const std::vector<Orbit> orbits = orbits_of(of, real);
  std::vector<int> rounded = of.counts;
  for (const Orbit& orbit : orbits)
    for (const int c : orbit.chords) rounded[c] = achieved(c, static_cast<int>(std::lround(real[orbit.chords[0]])));
  const WholeCounts from_real = descend(of, orbits, achieved, std::move(rounded)),
                    from_mesh = descend(of, orbits, achieved, of.counts);
  const WholeCounts& best = from_real.cost() <= from_mesh.cost() ? from_real : from_mesh;
  return {best.counts(), std::exp(best.log_error() - WholeCounts(of, of.counts).log_error())};
}

}  // namespace quadrille::sizing
