#include "curve/curve_set.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "curve/nurbs.hpp"
#include "curve/project.hpp"

namespace quadrille::curve {
namespace {

constexpr int newton_steps = 3;

double outside(double x, double low, double high) { return std::max({low - x, x - high, 0.0}); }

}  // namespace

double CurveSet::Span::distance_of_box(Vec2 x) const {
  return norm({outside(x.x, low.x, high.x), outside(x.y, low.y, high.y)});
}

CurveSet::CurveSet(std::vector<Nurbs> curves) : curves_(std::move(curves)) {
  for (std::size_t i = 0; i < curves_.size(); ++i) add_spans(static_cast<int>(i));
}

void CurveSet::add_spans(int curve) {
  const Nurbs& c = curves_[curve];
  for (std::size_t k = c.degree; k < c.poles.size(); ++k) {
    if (!(c.knots[k] < c.knots[k + 1])) continue;
    Span span{curve, c.knots[k], c.knots[k + 1], c.poles[k], c.poles[k]};
    for (std::size_t i = k - c.degree; i < k; ++i) {
      span.low = {std::min(span.low.x, c.poles[i].x), std::min(span.low.y, c.poles[i].y)};
      span.high = {std::max(span.high.x, c.poles[i].x), std::max(span.high.y, c.poles[i].y)};
    }
    spans_.push_back(span);
  }
}

double CurveSet::improve(Vec2 x, Guess& guess) const {
  const Nurbs& c = curves_[spans_[guess.span].curve];
  for (int step = 0; step < newton_steps; ++step) {
    const auto d = derivatives(c, guess.t);
    const double speed2 = norm2(d[1]);
    if (!(speed2 > 0)) break;
    guess.t = std::clamp(guess.t + dot(x - d[0], d[1]) / speed2, c.begin(), c.end());
  }
  return distance(x, point(c, guess.t));
}

double CurveSet::distance_above(Vec2 x, double known, Guess& guess) const {
  double nearest = improve(x, guess);
  const std::size_t first = guess.span;
  for (std::size_t k = 0; k < spans_.size() && nearest > known; ++k) {
    const std::size_t i = (first + k) % spans_.size();
    const Span& span = spans_[i];
    if (span.distance_of_box(x) >= nearest) continue;
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
