#include "sweep/space_spline.hpp"

#include <algorithm>

namespace quadrille::sweep {

namespace {

/// One equation of the slopes: below * s[i-1] + middle * s[i] + above * s[i+1] = right.
struct Row {
  double below = 0, middle = 0, above = 0;
  Vec3 right;
};

std::vector<Vec3> solved(std::vector<Row> rows) {
  const std::size_t n = rows.size();
  for (std::size_t i = 1; i < n; ++i) {
    const double factor = rows[i].below / rows[i - 1].middle;
    rows[i].middle -= factor * rows[i - 1].above;
    rows[i].right -= factor * rows[i - 1].right;
  }
  std::vector<Vec3> x(n);
  for (std::size_t i = n; i-- > 0;)
    x[i] = (rows[i].right - (i + 1 < n ? rows[i].above * x[i + 1] : Vec3{})) / rows[i].middle;
  return x;
}

/// The end at the point of `near`, the first length and slope of chord, and `next`, the second ones.
Row end_row(double near, Vec3 near_slope, double next, Vec3 next_slope) {
  const double sum = near + next;
  return {0, next, sum, ((near + 2 * sum) * next * near_slope + near * near * next_slope) / sum};
}

}  // namespace

std::vector<Vec3> spline_slopes(const std::vector<Vec3>& points, const std::vector<double>& knots) {
  const std::size_t n = points.size();
  std::vector<double> h;
  std::vector<Vec3> chord;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    h.push_back(knots[i + 1] - knots[i]);
    chord.push_back((points[i + 1] - points[i]) / h[i]);
  }
  if (n == 2) return {chord[0], chord[0]};
  if (n == 3) {
    const Vec3 bend = (chord[1] - chord[0]) / (h[0] + h[1]);
    return {chord[0] - h[0] * bend, chord[0] + h[0] * bend, chord[1] + h[1] * bend};
  }
  std::vector<Row> rows{end_row(h[0], chord[0], h[1], chord[1])};
  for (std::size_t i = 1; i + 1 < n; ++i)
    rows.push_back({h[i], 2 * (h[i - 1] + h[i]), h[i - 1], 3 * (h[i] * chord[i - 1] + h[i - 1] * chord[i])});
  Row last = end_row(h[n - 2], chord[n - 2], h[n - 3], chord[n - 3]);
  std::swap(last.below, last.above);
  rows.push_back(last);
  return solved(std::move(rows));
}

SpaceSpline::SpaceSpline(std::vector<Vec3> points) : points_(std::move(points)), knots_{0} {
  for (std::size_t i = 1; i < points_.size(); ++i)
    knots_.push_back(knots_.back() + distance(points_[i - 1], points_[i]));
  const double length = knots_.back();
  for (double& u : knots_) u /= length;
  knots_.back() = 1;
  slopes_ = spline_slopes(points_, knots_);
}

int SpaceSpline::span_of(double u) const {
  const auto next = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, u);
  return static_cast<int>(next - knots_.begin()) - 1;
}

Vec3 SpaceSpline::at(double u) const {
  const int i = span_of(u);
  const double h = knots_[i + 1] - knots_[i], t = (u - knots_[i]) / h, r = 1 - t;
  return r * r * (1 + 2 * t) * points_[i] + t * t * (3 - 2 * t) * points_[i + 1] +
         h * t * r * (r * slopes_[i] - t * slopes_[i + 1]);
}

Vec3 SpaceSpline::derivative(double u) const {
  const int i = span_of(u);
  const double h = knots_[i + 1] - knots_[i], t = (u - knots_[i]) / h, r = 1 - t;
  return 6 * t * r / h * (points_[i + 1] - points_[i]) + r * (1 - 3 * t) * slopes_[i] +
         t * (3 * t - 2) * slopes_[i + 1];
}

}  // namespace quadrille::sweep
