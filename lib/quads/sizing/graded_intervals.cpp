#include "sizing/graded_intervals.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace quadrille::sizing {
namespace {

constexpr double equal_tol = 1e-6;

/// F after `steps`, with s = log q; written so that no power overflows.
double grown(double h, double s, double steps, double cap) {
  return s > 0 ? cap * h / (cap * std::exp(-s * steps) + h * (1 - std::exp(-s * steps)))
               : cap * h * std::exp(s * steps) / (cap + h * (std::exp(s * steps) - 1));
}

std::vector<double> family(const GradedEnds& ends, int count, double s, double cap) {
  std::vector<double> intervals;
  for (int i = 1; i <= count; ++i) {
    const double x = static_cast<double>(i) / (count + 1);
    const double front = ends.before > 0 ? grown(ends.before, s, i, cap) : 0;
    const double back = ends.after > 0 ? grown(ends.after, s, count + 1 - i, cap) : 0;
    intervals.push_back(front > 0 && back > 0 ? std::pow(front, 1 - x) * std::pow(back, x) : std::max(front, back));
  }
  return intervals;
}

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

}  // namespace

std::vector<double> graded_intervals(const GradedEnds& ends, int count, double length, double cap) {
  if (ends.are_free()) return std::vector<double>(count, length / count);
  // The family must be able to reach the sum, and to start from its neighbours.
  const double reach = std::max({cap, 1.25 * length / count, 2 * ends.before, 2 * ends.after});
  double low = -30, high = 30;
  for (int step = 0; step < 60; ++step) {
    const double s = (low + high) / 2;
    (sum(family(ends, count, s, reach)) < length ? low : high) = s;
  }
  std::vector<double> intervals = family(ends, count, (low + high) / 2, reach);
  const double factor = length / sum(intervals);
  for (double& interval : intervals) interval *= factor;
  return intervals;
}

double worst_growth(const GradedEnds& ends, const std::vector<double>& intervals) {
  double worst = 1;
  const auto compare = [&](double a, double b) {
    if (a > 0 && b > 0) worst = std::max({worst, a / b, b / a});
  };
  compare(ends.before, intervals.front());
  for (std::size_t i = 1; i < intervals.size(); ++i) compare(intervals[i - 1], intervals[i]);
  compare(intervals.back(), ends.after);
  return worst;
}

int least_graded_count(const GradedEnds& ends, double length, double cap, double growth, int most) {
  const auto suffices = [&](int count) {
    if (length > (1 + equal_tol) * count * cap) return false;
    const std::vector<double> intervals = graded_intervals(ends, count, length, cap);
    // The intervals are already crowded, and a larger count would not change this.
    const double smallest = *std::min_element(intervals.begin(), intervals.end());
    const bool is_crowded = !ends.are_free() && smallest < std::min(ends.before > 0 ? ends.before : ends.after,
                                                                    ends.after > 0 ? ends.after : ends.before) *
                                                               (1 - equal_tol);
    return is_crowded || worst_growth(ends, intervals) <= growth * (1 + equal_tol);
  };
  int low = 0, high = 1;
  while (high < most && !suffices(high)) low = high, high = std::min(2 * high, most);
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    (suffices(middle) ? high : low) = middle;
  }
  return high;
}

}  // namespace quadrille::sizing
