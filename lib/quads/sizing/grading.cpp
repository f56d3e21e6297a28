#include "sizing/grading.hpp"

#include <algorithm>
#include <cmath>

namespace quadrille::sizing {
namespace {

constexpr double same_length = 1e-9;
constexpr double same_position = 1e-12;

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

}  // namespace

Grading::Grading(std::vector<double> u, std::vector<double> eta) {
  std::vector<double> n{0.0};
  for (std::size_t k = 1; k < u.size(); ++k) {
    const double width = u[k] - u[k - 1];
    n.push_back(n.back() + elements_in(eta[k - 1], (eta[k] - eta[k - 1]) / width, width));
  }
  count_ = n.back();
  const auto [least, greatest] = std::minmax_element(eta.begin(), eta.end());
  if (*greatest <= (1 + same_length) * *least) return;
  u_ = std::move(u), eta_ = std::move(eta), n_ = std::move(n);
}

double Grading::parameter(double v) const {
  if (is_identity() || v <= 0 || v >= 1) return std::clamp(v, 0.0, 1.0);
  const double n = v * count_;
  const std::size_t k = std::clamp<std::ptrdiff_t>(std::upper_bound(n_.begin(), n_.end(), n) - n_.begin(), 1,
                                                   static_cast<std::ptrdiff_t>(n_.size()) - 1);
  const double rise = (eta_[k] - eta_[k - 1]) / (u_[k] - u_[k - 1]);
  return std::clamp(u_[k - 1] + width_of(eta_[k - 1], rise, n - n_[k - 1]), u_[k - 1], u_[k]);
}

double Grading::cumulative(double u) const {
  if (is_identity() || u <= 0 || u >= 1) return std::clamp(u, 0.0, 1.0);
  const std::size_t k = std::clamp<std::ptrdiff_t>(std::upper_bound(u_.begin(), u_.end(), u) - u_.begin(), 1,
                                                   static_cast<std::ptrdiff_t>(u_.size()) - 1);
  const double rise = (eta_[k] - eta_[k - 1]) / (u_[k] - u_[k - 1]);
  return std::min(1.0, (n_[k - 1] + elements_in(eta_[k - 1], rise, u - u_[k - 1])) / count_);
}

double Grading::element_length(double u) const {
  if (is_identity()) return 1 / count_;
  const std::size_t k = std::clamp<std::ptrdiff_t>(std::upper_bound(u_.begin(), u_.end(), u) - u_.begin(), 1,
                                                   static_cast<std::ptrdiff_t>(u_.size()) - 1);
  const double x = (u - u_[k - 1]) / (u_[k] - u_[k - 1]);
  return (1 - x) * eta_[k - 1] + x * eta_[k];
}

namespace {

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

}  // namespace quadrille::sizing
