#include "sizing/grading.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/tolerance.hpp"

namespace quadrille::sizing {
namespace {

constexpr double same_position = 1e-12;

/// The number of the sample at which the piece with x ends.
std::size_t piece_end(const std::vector<double>& samples, double x) {
  return std::clamp<std::ptrdiff_t>(std::ranges::upper_bound(samples, x) - samples.begin(), 1, std::ssize(samples) - 1);
}

/// The integral of 1 / (eta + rise x) over x in [0, width].
double elements_in(double eta, double rise, double width) {
  const double growth = rise * width / eta;
  // log1p(g) / g without the quotient of small numbers
  return width / eta * (std::abs(growth) < 1e-8 ? 1 - growth / 2 : std::log1p(growth) / growth);
}

/// The width that contains n elements: the inverse of elements_in.
double width_of(double eta, double rise, double n) {
  const double growth = rise * n;
  return n * eta * (std::abs(growth) < 1e-8 ? 1 + growth / 2 : std::expm1(growth) / growth);
}

/// Where the refined lengths are sampled: at the samples of the grading, and around each constraint at distances that
/// double, as lengths can grow from it.
std::vector<double> refined_samples(const Grading& grading, const std::vector<MaxLengthConstraint>& constraints) {
  std::vector<double> u{0.0, 1.0};
  u.insert(u.end(), grading.samples().begin(), grading.samples().end());
  for (const MaxLengthConstraint& c : constraints)
    for (double away = 0, step = c.max_length; away < 1; away += step, step *= 2) {
      if (c.low - away > 0) u.push_back(c.low - away);
      if (c.high + away < 1) u.push_back(c.high + away);
    }
  std::sort(u.begin(), u.end());
  u.erase(std::unique(u.begin(), u.end(), [](double a, double b) { return b - a < same_position; }), u.end());
  u.back() = 1;
  return u;
}

}  // namespace

Grading::Grading(std::vector<double> u, std::vector<double> eta) {
  std::vector<double> n{0.0};
  for (std::size_t k = 1; k < u.size(); ++k) {
    const double width = u[k] - u[k - 1];
    n.push_back(n.back() + elements_in(eta[k - 1], (eta[k] - eta[k - 1]) / width, width));
  }
  count_ = n.back();
  const auto [least, greatest] = std::minmax_element(eta.begin(), eta.end());
  if (*greatest <= (1 + tolerance::round_off) * *least) return;
  u_ = std::move(u), eta_ = std::move(eta), n_ = std::move(n);
}

double Grading::parameter(double v) const {
  if (is_identity() || v <= 0 || v >= 1) return std::clamp(v, 0.0, 1.0);
  const double n = v * count_;
  const std::size_t k = piece_end(n_, n);
  const double rise = (eta_[k] - eta_[k - 1]) / (u_[k] - u_[k - 1]);
  return std::clamp(u_[k - 1] + width_of(eta_[k - 1], rise, n - n_[k - 1]), u_[k - 1], u_[k]);
}

double Grading::cumulative(double u) const {
  if (is_identity() || u <= 0 || u >= 1) return std::clamp(u, 0.0, 1.0);
  const std::size_t k = piece_end(u_, u);
  const double rise = (eta_[k] - eta_[k - 1]) / (u_[k] - u_[k - 1]);
  return std::min(1.0, (n_[k - 1] + elements_in(eta_[k - 1], rise, u - u_[k - 1])) / count_);
}

double Grading::element_length(double u) const {
  if (is_identity()) return 1 / count_;
  const std::size_t k = piece_end(u_, u);
  const double x = (u - u_[k - 1]) / (u_[k] - u_[k - 1]);
  return (1 - x) * eta_[k - 1] + x * eta_[k];
}

Grading refine_grading(const Grading& grading, double count, const std::vector<MaxLengthConstraint>& constraints,
                       double slope) {
  std::vector<double> u = refined_samples(grading, constraints), before;
  for (const double at : u) before.push_back(grading.element_length(at) * grading.count() / count);
  std::vector<double> lengths = before;
  for (const MaxLengthConstraint& c : constraints)
    for (auto k = std::lower_bound(u.begin(), u.end(), c.low - same_position) - u.begin();
         k < std::ssize(u) && u[k] <= c.high + same_position; ++k)
      lengths[k] = std::min({lengths[k], c.max_length, before[k] / c.reduction});
  lengths = limited(u, std::move(lengths), slope);
  return {std::move(u), std::move(lengths)};
}

std::vector<double> limited(const std::vector<double>& u, std::vector<double> eta, double slope) {
  for (std::size_t k = 1; k < eta.size(); ++k) eta[k] = std::min(eta[k], eta[k - 1] + slope * (u[k] - u[k - 1]));
  for (std::size_t k = eta.size() - 1; k > 0; --k)
    eta[k - 1] = std::min(eta[k - 1], eta[k] + slope * (u[k] - u[k - 1]));
  return eta;
}

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
      if (interval(i) >= (1 - tolerance::tied) * longest) equal.push_back(i);
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
