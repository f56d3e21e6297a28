#include "chart/space_length.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "spectral/quadrature.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::chart {
namespace {

constexpr int num_points = 10, most_halvings = 20;
constexpr double round_off = 1e-14;

}  // namespace

SpaceLength::SpaceLength(const SpaceCurve& curve) : curve_(&curve), parameters_{curve.begin()}, lengths_{0} {
  for (std::size_t i = 1; i < curve.knots.size(); ++i) {
    const double a = curve.knots[i - 1], b = curve.knots[i];
    if (!(a < b)) continue;
    const double whole = gauss(a, b);
    // The place between knots, and with it the speed there, is as accurate as the parameter.
    const double rounded = std::numeric_limits<double>::epsilon() * std::max(std::abs(a), std::abs(b)) / (b - a);
    add(a, b, whole, std::max(round_off, rounded) * whole, 0);
  }
}

double SpaceLength::gauss(double a, double b) const {
  static const spectral::Quadrature rule = spectral::gauss_legendre(num_points);
  double sum = 0;
  for (int i = 0; i < num_points; ++i) {
    const double t = (a + b) / 2 + (b - a) / 2 * rule.points[i];
    sum += rule.weights[i] * norm(surface::derivatives(*curve_, t)[1]);
  }
  return sum * (b - a) / 2;
}

void SpaceLength::add(double a, double b, double whole, double tolerance, int depth) {
  const double middle = (a + b) / 2, first = gauss(a, middle), second = gauss(middle, b);
  if (std::abs(first + second - whole) > tolerance && depth < most_halvings) {
    add(a, middle, first, tolerance, depth + 1);
    add(middle, b, second, tolerance, depth + 1);
    return;
  }
  parameters_.push_back(b);
  lengths_.push_back(lengths_.back() + first + second);
}

double SpaceLength::at(double t) const {
  if (t <= parameters_.front()) return 0;
  if (t >= parameters_.back()) return total();
  const auto i = std::upper_bound(parameters_.begin(), parameters_.end(), t) - parameters_.begin() - 1;
  return lengths_[i] + gauss(parameters_[i], t);
}

// Newton's method, kept between the ends of the interval.
double SpaceLength::parameter(double length) const {
  if (length <= 0) return parameters_.front();
  if (length >= total()) return parameters_.back();
  const auto i = std::upper_bound(lengths_.begin(), lengths_.end(), length) - lengths_.begin() - 1;
  double low = parameters_[i], high = parameters_[i + 1];
  double t = low + (high - low) * (length - lengths_[i]) / (lengths_[i + 1] - lengths_[i]);
  for (int step = 0; step < 50; ++step) {
    const double excess = lengths_[i] + gauss(parameters_[i], t) - length;
    (excess > 0 ? high : low) = t;
    const double speed = norm(surface::derivatives(*curve_, t)[1]);
    double next = t - excess / speed;
    if (!(next >= low && next <= high)) next = (low + high) / 2;
    if (std::abs(next - t) <= 4e-16 * std::max(std::abs(parameters_.front()), std::abs(parameters_.back())))
      return next;
    t = next;
  }
  return t;
}

}  // namespace quadrille::chart
