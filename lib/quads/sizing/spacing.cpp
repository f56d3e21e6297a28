#include "sizing/spacing.hpp"

#include <algorithm>
#include <numeric>

namespace quadrille::sizing {
namespace {

/// Lengths that differ by less, relatively, count as equal.
constexpr double equal_tol = 1e-6;

}  // namespace

int Segments::least_count() const { return std::accumulate(least_counts.begin(), least_counts.end(), 0); }

std::vector<int> segment_counts(const Segments& segments, int count, bool break_ties) {
  std::vector<int> counts = segments.least_counts;
  int left = count - segments.least_count();
  const auto interval = [&](std::size_t i) { return (segments.ends[i + 1] - segments.ends[i]) / counts[i]; };
  while (left > 0) {
    double longest = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) longest = std::max(longest, interval(i));
    std::vector<std::size_t> equal;
    for (std::size_t i = 0; i < counts.size(); ++i)
      if (interval(i) >= (1 - equal_tol) * longest) equal.push_back(i);
    if (static_cast<int>(equal.size()) > left) {
      if (!break_ties) return {};
      equal.resize(left);
    }
    for (const std::size_t i : equal) ++counts[i];
    left -= static_cast<int>(equal.size());
  }
  return counts;
}

std::vector<double> interval_ends(const Segments& segments, const std::vector<int>& counts) {
  std::vector<double> ends{0.0};
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double low = segments.ends[i], high = segments.ends[i + 1];
    for (int k = 1; k < counts[i]; ++k) ends.push_back((low * (counts[i] - k) + high * k) / counts[i]);
    ends.push_back(high);
  }
  return ends;
}

}  // namespace quadrille::sizing
