#include "curve/curve_set.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "curve/nurbs.hpp"
#include "curve/project.hpp"

namespace quadrille::curve {
namespace {

constexpr int newton_steps = 3;
/// Successive spans are near each other: one box around so many spares looking at each.
constexpr std::size_t group_size = 16;

double outside(double x, double low, double high) { return std::max({low - x, x - high, 0.0}); }

}  // namespace

void CurveSet::Box::extend(const Box& other) {
  low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y)};
  high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y)};
}

double CurveSet::Box::distance2(Vec2 x) const {
  return norm2({outside(x.x, low.x, high.x), outside(x.y, low.y, high.y)});
}

CurveSet::CurveSet(std::vector<Nurbs> curves) : curves_(std::move(curves)) {
  for (std::size_t i = 0; i < curves_.size(); ++i) add_spans(static_cast<int>(i));
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    if (i % group_size == 0) groups_.push_back(spans_[i].box);
    groups_.back().extend(spans_[i].box);
  }
}

void CurveSet::add_spans(int curve) {
  const Nurbs& c = curves_[curve];
  for (std::size_t k = c.degree; k < c.poles.size(); ++k) {
    if (!(c.knots[k] < c.knots[k + 1])) continue;
    Span span{curve, c.knots[k], c.knots[k + 1], {c.poles[k], c.poles[k]}};
    for (std::size_t i = k - c.degree; i < k; ++i) span.box.extend({c.poles[i], c.poles[i]});
    spans_.push_back(span);
  }
}

double CurveSet::improve(Vec2 x, double known, Guess& guess) const {
  const Nurbs& c = curves_[spans_[guess.span].curve];
  for (int step = 0; step < newton_steps; ++step) {
    const PointAndDerivative at = point_and_derivative(c, guess.t);
    const Vec2 missing = x - at.point;
    const double distance2 = norm2(missing), speed2 = norm2(at.derivative);
    if (distance2 <= known * known || !(speed2 > 0)) return std::sqrt(distance2);
    guess.t = std::clamp(guess.t + dot(missing, at.derivative) / speed2, c.begin(), c.end());
  }
  return distance(x, point(c, guess.t));
}

double CurveSet::distance_above(Vec2 x, double known, Guess& guess) const {
  double nearest = improve(x, known, guess);
  const std::size_t first = guess.span;
  for (std::size_t k = 0; k < spans_.size() && nearest > known; ++k) {
    const std::size_t i = (first + k) % spans_.size();
    if (i % group_size == 0 && groups_[i / group_size].distance2(x) >= nearest * nearest) {
      k += std::min(group_size, spans_.size() - i) - 1;
      continue;
    }
    const Span& span = spans_[i];
    if (span.box.distance2(x) >= nearest * nearest) continue;
    const Projection found = project(curves_[span.curve], x, span.t0, span.t1);
    if (found.distance >= nearest) continue;
    nearest = found.distance;
    guess = {i, found.t};
  }
  return nearest;
}

FarthestPoint CurveSet::farthest(const std::vector<Vec2>& points) const {
  FarthestPoint result;
  if (spans_.empty()) return result;
  Guess guess{0, spans_[0].t0};
  for (const Vec2 x : points)
    if (const double d = distance_above(x, result.distance, guess); d > result.distance) result = {d, x};
  return result;
}

}  // namespace quadrille::curve
