#include "offset/smoothed_ratio.hpp"

#include <algorithm>
#include <cmath>

#include "offset/offset_rules.hpp"

namespace quadrille::offset {
namespace {

/// Half of the length over which ratios are averaged.
double half_width(const RatioSamples& samples) { return std::min(samples.distance, samples.lengths.back() / 2) / 2; }

/// The least ratio within twice that length and two intervals, so that averages are not above the ratios.
std::vector<double> least_around(const RatioSamples& samples) {
  const std::vector<double>& lengths = samples.lengths;
  double interval = 0;
  for (std::size_t k = 1; k < lengths.size(); ++k) interval = std::max(interval, lengths[k] - lengths[k - 1]);
  const double reach = 2 * (half_width(samples) + interval);
  std::vector<double> least;
  for (const double s : lengths) {
    double value = 1;
    for (std::size_t k = 0; k < lengths.size(); ++k) {
      const double apart = std::abs(lengths[k] - s);
      const double shortest = samples.is_closed ? std::min(apart, lengths.back() - apart) : apart;
      if (shortest <= reach) value = std::min(value, samples.ratios[k]);
    }
    least.push_back(value);
  }
  return least;
}

void limit_slope(const RatioSamples& samples, std::vector<double>& ratios) {
  const double slope = offset_constants.greatest_slope / samples.distance;
  const std::size_t last = ratios.size() - 1;
  const auto step = [&](std::size_t from, std::size_t to) {
    ratios[to] = std::min(ratios[to], ratios[from] + slope * std::abs(samples.lengths[to] - samples.lengths[from]));
  };
  for (int round = 0; round < (samples.is_closed ? 2 : 1); ++round) {
    for (std::size_t k = 0; k < last; ++k) step(k, k + 1);
    for (std::size_t k = last; k > 0; --k) step(k, k - 1);
    if (samples.is_closed) ratios.front() = ratios.back() = std::min(ratios.front(), ratios.back());
  }
}

/// A piecewise linear function, continued periodically or by its end values, and its integral.
class LinearFunction {
 public:
  LinearFunction(const RatioSamples& samples, const std::vector<double>& values)
      : samples_(samples), values_(values), integrals_{0} {
    for (std::size_t k = 1; k < values.size(); ++k)
      integrals_.push_back(integrals_.back() +
                           (samples.lengths[k] - samples.lengths[k - 1]) * (values[k] + values[k - 1]) / 2);
  }

  double value(double s) const {
    const auto [k, rest] = place(wrapped(s).second);
    const double h = samples_.lengths[k + 1] - samples_.lengths[k];
    return values_[k] + (values_[k + 1] - values_[k]) * std::clamp(rest / h, 0.0, 1.0);
  }

  /// From the start of the chain.
  double integral(double s) const {
    const double total = samples_.lengths.back();
    const auto [turns, inside] = wrapped(s);
    if (!samples_.is_closed && s < 0) return s * values_.front();
    if (!samples_.is_closed && s > total) return integrals_.back() + (s - total) * values_.back();
    const auto [k, rest] = place(inside);
    return turns * integrals_.back() + integrals_[k] + rest * (values_[k] + value(inside)) / 2;
  }

 private:
  /// Whole turns, and the length in [0, total].
  std::pair<double, double> wrapped(double s) const {
    const double total = samples_.lengths.back();
    if (!samples_.is_closed) return {0, std::clamp(s, 0.0, total)};
    const double turns = std::floor(s / total);
    return {turns, std::clamp(s - turns * total, 0.0, total)};
  }
  std::pair<std::size_t, double> place(double s) const {
    const auto above = std::upper_bound(samples_.lengths.begin() + 1, samples_.lengths.end() - 1, s);
    const std::size_t k = static_cast<std::size_t>(above - samples_.lengths.begin()) - 1;
    return {k, s - samples_.lengths[k]};
  }

  const RatioSamples& samples_;
  const std::vector<double>& values_;
  std::vector<double> integrals_;
};

SmoothRatios averaged(const RatioSamples& samples, const std::vector<double>& values) {
  const LinearFunction function(samples, values);
  const double half = half_width(samples);
  SmoothRatios smooth;
  for (const double s : samples.lengths) {
    smooth.ratios.push_back((function.integral(s + half) - function.integral(s - half)) / (2 * half));
    smooth.slopes.push_back((function.value(s + half) - function.value(s - half)) / (2 * half));
  }
  return smooth;
}

}  // namespace

SmoothRatios smoothed_ratios(const RatioSamples& samples) {
  std::vector<double> ratios = least_around(samples);
  limit_slope(samples, ratios);
  return averaged(samples, averaged(samples, ratios).ratios);
}

}  // namespace quadrille::offset
