#include "curve/arc_length.hpp"

#include <algorithm>
#include <cmath>

#include "curve/gauss.hpp"
#include "curve/nurbs.hpp"

namespace quadrille {
namespace {

double speed(const Nurbs& curve, double t) { return norm(derivatives(curve, t)[1]); }

double gauss(const Nurbs& curve, double a, double b) {
  return gauss_integral([&](double t) { return speed(curve, t); }, a, b);
}

}  // namespace

ArcLength::ArcLength(const Nurbs& curve) : curve_(&curve), parameters_{curve.begin()}, lengths_{0} {
  if (is_polyline()) {
    for (size_t i = 1; i < curve.poles.size(); ++i) {
      parameters_.push_back(curve.knots[i + 1]);
      lengths_.push_back(lengths_.back() + distance(curve.poles[i - 1], curve.poles[i]));
    }
    return;
  }
  double scale = 0;
  for (size_t i = 1; i < curve.poles.size(); ++i) scale += distance(curve.poles[i - 1], curve.poles[i]);
  struct Interval {
    double a, b, length;
    int depth;
  };
  std::vector<Interval> stack;
  for (size_t i = curve.knots.size() - 1; i > 0; --i) {
    const double a = curve.knots[i - 1], b = curve.knots[i];
    if (a < b) stack.push_back({a, b, gauss(curve, a, b), 0});
  }
  while (!stack.empty()) {
    const Interval whole = stack.back();
    stack.pop_back();
    const double m = (whole.a + whole.b) / 2;
    const double left = gauss(curve, whole.a, m), right = gauss(curve, m, whole.b);
    if (std::abs(left + right - whole.length) <= 1e-14 * scale || whole.depth == 40) {
      parameters_.push_back(whole.b);
      lengths_.push_back(lengths_.back() + whole.length);
    } else {
      stack.push_back({m, whole.b, right, whole.depth + 1});
      stack.push_back({whole.a, m, left, whole.depth + 1});
    }
  }
}

double ArcLength::at(double t) const {
  if (t <= parameters_.front()) return 0;
  if (t >= parameters_.back()) return lengths_.back();
  const size_t i = std::upper_bound(parameters_.begin(), parameters_.end(), t) - parameters_.begin() - 1;
  if (t == parameters_[i]) return lengths_[i];
  if (is_polyline()) return lengths_[i] + (lengths_[i + 1] - lengths_[i]) * fraction(i, t);
  // The shorter way, so that the middle of a symmetric curve is its middle to the last digit.
  if (fraction(i, t) <= 0.5) return lengths_[i] + gauss(*curve_, parameters_[i], t);
  return lengths_[i + 1] - gauss(*curve_, t, parameters_[i + 1]);
}

double ArcLength::parameter(double length) const {
  if (length <= 0) return parameters_.front();
  if (length >= lengths_.back()) return parameters_.back();
  const size_t i = std::upper_bound(lengths_.begin(), lengths_.end(), length) - lengths_.begin() - 1;
  double low = parameters_[i], high = parameters_[i + 1];
  const double share = (length - lengths_[i]) / (lengths_[i + 1] - lengths_[i]);
  double t = low + (high - low) * share;
  if (length == lengths_[i]) return low;
  if (is_polyline()) return t;
  const double span = high - low;
  for (int iteration = 0; iteration < 60; ++iteration) {
    const double missing = length - at(t);
    (missing > 0 ? low : high) = t;
    const double slope = speed(*curve_, t);
    double next = t + missing / slope;
    if (!(next > low && next < high)) {
      if (next == low || next == high) return next;
      next = (low + high) / 2;
    }
    const double moved = std::abs(next - t);
    t = next;
    // Newton squares the error: a step of 1e-9 of the interval leaves 1e-18 of it.
    if (moved <= 1e-9 * span) break;
  }
  return t;
}

bool ArcLength::is_polyline() const {
  return curve_->degree == 1 &&
         std::all_of(curve_->weights.begin(), curve_->weights.end(), [&](double w) { return w == curve_->weights[0]; });
}

double ArcLength::fraction(size_t interval, double t) const {
  return (t - parameters_[interval]) / (parameters_[interval + 1] - parameters_[interval]);
}

}  // namespace quadrille
