#include "prescribe/log_spacing.hpp"

#include <algorithm>
#include <cmath>

namespace quadrille::prescribe {
namespace {

constexpr int least_samples = 256;
constexpr double most_of_length = 0.9;  ///< that the two end elements may have together
constexpr int bisections = 60;
constexpr int end_rounds = 8;          ///< a few suffice: the first element depends little on the last
constexpr double rounding = 0.1;       ///< r
constexpr double greatest_bulge = 80;  ///< |k|: with more, the last element is lost to rounding
constexpr double greatest_ratio = 60;  ///< |b - a|, with one end free

}  // namespace

LogSpacing::LogSpacing(int count, double length, double first, double last)
    : count_(count), steps_(std::max(1, (least_samples + count - 1) / count)), length_(length) {
  const double most = most_of_length * length;
  if (count == 2 && first > 0 && last > 0) {
    first *= length / (first + last);
    last = 0;
  }
  if (count == 1 || first + last <= 0) {
    sample({}, 0);
  } else if (first > 0 && last > 0) {
    const double factor = std::min(1.0, most / (first + last));
    solve_both(factor * first, factor * last);
  } else {
    solve_one(std::min(first + last, most));
    if (last > 0) {
      std::ranges::reverse(element_lengths_);
      std::ranges::reverse(positions_);
      const double end = positions_.front();
      for (double& x : positions_) x = end - x;
    }
  }
  const double factor = length_ / positions_.back();
  for (double& x : positions_) x *= factor;
  for (double& l : element_lengths_) l *= factor;
  positions_.back() = length_;
}

/// Simpson's rule on each step.
void LogSpacing::sample(const Ends& ends, double bulge) {
  const int num = count_ * steps_;
  const auto rise = [](double v) { return std::hypot(rounding, 0.5) - std::hypot(rounding, v - 0.5); };
  const auto local = [&](double v) { return std::exp((1 - v) * ends.a + v * ends.b + bulge * rise(v)); };
  positions_.assign(1, 0.0);
  element_lengths_.assign(1, local(0));
  for (int j = 0; j < num; ++j) {
    const double high = local((j + 1.0) / num);
    const double mean = (element_lengths_.back() + 4 * local((j + 0.5) / num) + high) / 6;
    positions_.push_back(positions_.back() + mean / steps_);
    element_lengths_.push_back(high);
  }
}

void LogSpacing::meet_ends(double first, double last, double bulge, Ends& ends) {
  for (int round = 0; round < end_rounds; ++round) {
    sample(ends, bulge);
    ends.a += std::log(first / positions_[steps_]);
    ends.b += std::log(last / (positions_.back() - positions_[positions_.size() - 1 - steps_]));
  }
  sample(ends, bulge);
}

/// The whole length rises with the bulge.
void LogSpacing::solve_both(double first, double last) {
  double low = -greatest_bulge, high = greatest_bulge;
  Ends ends{std::log(first), std::log(last)};
  for (int step = 0; step < bisections; ++step) {
    const double bulge = (low + high) / 2;
    meet_ends(first, last, bulge, ends);
    (positions_.back() < length_ ? low : high) = bulge;
  }
}

void LogSpacing::solve_one(double first) {
  double low = -greatest_ratio, high = greatest_ratio;
  for (int step = 0; step < bisections; ++step) {
    const double ratio = (low + high) / 2;
    sample({0, ratio}, 0);
    (positions_.back() * first < length_ * positions_[steps_] ? low : high) = ratio;
  }
}

double LogSpacing::element_length(double x) const {
  const auto above = std::ranges::upper_bound(positions_, x);
  const auto j = std::clamp<std::ptrdiff_t>(above - positions_.begin(), 1, std::ssize(positions_) - 1);
  const double fraction = std::clamp((x - positions_[j - 1]) / (positions_[j] - positions_[j - 1]), 0.0, 1.0);
  return element_lengths_[j - 1] + fraction * (element_lengths_[j] - element_lengths_[j - 1]);
}

}  // namespace quadrille::prescribe
