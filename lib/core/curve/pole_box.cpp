#include "curve/pole_box.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "curve/nurbs.hpp"

namespace quadrille::curve {

void PoleBox::extend(const PoleBox& other) {
  low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y)};
  high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y)};
}

double PoleBox::distance_from(Vec2 x) const {
  return norm(Vec2{std::max({low.x - x.x, x.x - high.x, 0.0}), std::max({low.y - x.y, x.y - high.y, 0.0})});
}

PoleBox pole_box(const Nurbs& curve) {
  PoleBox box{curve.poles.front(), curve.poles.front()};
  for (const Vec2 p : curve.poles) box.extend({p, p});
  return box;
}

PoleBox pole_box(const std::vector<Nurbs>& curves) {
  PoleBox box = pole_box(curves.front());
  for (const Nurbs& curve : curves) box.extend(pole_box(curve));
  return box;
}

namespace {

// Points at the quarters of the spans of a curve: three points of a span lie on a circle in any case.
std::vector<Vec2> samples(const Nurbs& curve) {
  std::vector<Vec2> points{curve.poles.front()};
  for (size_t k = 1; k < curve.knots.size(); ++k) {
    const double a = curve.knots[k - 1], b = curve.knots[k];
    if (!(a < b)) continue;
    for (int quarter = 1; quarter <= 4; ++quarter) points.push_back(point(curve, a + (b - a) * quarter / 4));
  }
  return points;
}

// The centre of the circle through three points, relative to the first; b and c are relative to it, too.
std::optional<Vec2> centre_of(Vec2 b, Vec2 c) {
  const double twice_area = 2 * cross(b, c);
  if (std::abs(twice_area) <= 1e-12 * norm(b) * norm(c)) return std::nullopt;
  return Vec2{c.y * norm2(b) - b.y * norm2(c), b.x * norm2(c) - c.x * norm2(b)} / twice_area;
}

std::optional<Carrier> circle_of(const Nurbs& curve) {
  const std::vector<Vec2> points = samples(curve);
  const auto centre = centre_of(points[2] - points[0], points[4] - points[0]);
  if (!centre) return std::nullopt;
  const Carrier circle{CurveKind::arc, points[0] + *centre, {}, norm(*centre)};
  const auto lies_on = [&](Vec2 x) { return std::abs(distance(x, circle.point) / circle.radius - 1) < 1e-9; };
  if (!std::all_of(points.begin(), points.end(), lies_on)) return std::nullopt;
  return circle;
}

// The points of a circle nearest to and farthest from x on the line through `foot` in `direction`.
std::optional<Vec2> on_circle(const Carrier& circle, Vec2 foot, Vec2 direction, Vec2 x) {
  const double height2 = circle.radius * circle.radius - norm2(foot - circle.point);
  if (height2 < 0) return std::nullopt;
  const double half = std::sqrt(height2);
  const Vec2 one = foot + half * direction, other = foot - half * direction;
  return distance(one, x) <= distance(other, x) ? one : other;
}

std::optional<Vec2> of_circles(const Carrier& a, const Carrier& b, Vec2 x) {
  const Vec2 between = b.point - a.point;
  const double d2 = norm2(between);
  if (d2 == 0) return std::nullopt;
  const double s = (d2 + a.radius * a.radius - b.radius * b.radius) / (2 * d2);
  return on_circle(a, a.point + s * between, left_of(between) / std::sqrt(d2), x);
}

}  // namespace

Carrier carrier_of(const Nurbs& curve) {
  if (curve.degree == 1 && curve.poles.size() == 2 && distance(curve.poles[0], curve.poles[1]) > 0)
    return {CurveKind::line, curve.poles[0], normalized(curve.poles[1] - curve.poles[0]), 0};
  if (curve.degree == 2)
    if (const auto circle = circle_of(curve)) return *circle;
  return {};
}

Vec2 nearest_on(const Carrier& carrier, Vec2 x) {
  const Vec2 d = x - carrier.point;
  if (carrier.kind == CurveKind::line) return carrier.point + dot(d, carrier.direction) * carrier.direction;
  if (carrier.kind == CurveKind::arc && norm2(d) > 0) return carrier.point + carrier.radius * normalized(d);
  return x;
}

std::optional<Vec2> intersection(const Carrier& a, const Carrier& b, Vec2 x) {
  if (a.kind < b.kind) return intersection(b, a, x);
  if (b.kind == CurveKind::spline) return std::nullopt;
  if (a.kind == CurveKind::arc) return of_circles(a, b, x);
  if (b.kind == CurveKind::arc) return on_circle(b, nearest_on(a, b.point), a.direction, x);
  const double sine = cross(a.direction, b.direction);
  if (sine == 0) return std::nullopt;
  return a.point + cross(b.point - a.point, b.direction) / sine * a.direction;
}

}  // namespace quadrille::curve
