#include "sizing/arc_parameter.hpp"

#include <algorithm>

namespace quadrille::sizing {

ArcParameter::ArcParameter(std::vector<double> fractions) : fractions_(std::move(fractions)) {
  const std::size_t last = fractions_.size() - 1;
  for (std::size_t k = 0; k <= last; ++k) {
    // Slopes at most three times the lesser neighbouring difference keep every piece monotone (Fritsch and Carlson).
    const double before = k > 0 ? fractions_[k] - fractions_[k - 1] : fractions_[1] - fractions_[0];
    const double after = k < last ? fractions_[k + 1] - fractions_[k] : before;
    slopes_.push_back(std::min((before + after) / 2, 3 * std::min(before, after)));
  }
}

double ArcParameter::fraction(double u) const {
  if (is_identity() || u <= 0 || u >= 1) return std::clamp(u, 0.0, 1.0);
  const double x = u * static_cast<double>(fractions_.size() - 1);
  const std::size_t k = std::min(static_cast<std::size_t>(x), fractions_.size() - 2);
  const double t = x - static_cast<double>(k), r = 1 - t;
  return r * r * (1 + 2 * t) * fractions_[k] + t * t * (1 + 2 * r) * fractions_[k + 1] +
         r * t * (r * slopes_[k] - t * slopes_[k + 1]);
}

double ArcParameter::parameter(double f) const {
  if (is_identity() || f <= 0 || f >= 1) return std::clamp(f, 0.0, 1.0);
  double low = 0, high = 1;
  for (int step = 0; step < 60; ++step) {
    const double middle = (low + high) / 2;
    (fraction(middle) < f ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace quadrille::sizing
