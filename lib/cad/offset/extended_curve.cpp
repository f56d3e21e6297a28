#include "offset/extended_curve.hpp"

#include <algorithm>

#include "curve/nurbs.hpp"

namespace quadrille::offset {
namespace {

constexpr int max_steps = 60;

}  // namespace

Vec2 ExtendedCurve::point(double t) const {
  const double inside = std::clamp(t, curve_->begin(), curve_->end());
  return curve::point(*curve_, inside) + (t - inside) * derivative(inside);
}

Vec2 ExtendedCurve::derivative(double t) const {
  const double inside = std::clamp(t, curve_->begin(), curve_->end());
  return curve::derivative(*curve_, inside, inside >= curve_->end());
}

double ExtendedCurve::beside_start(double length) const {
  return curve_->begin() + length / norm(derivative(curve_->begin()));
}

double ExtendedCurve::beside_end(double length) const {
  return curve_->end() + length / norm(derivative(curve_->end()));
}

std::optional<ExtendedCrossing> crossing_near(const ExtendedCurve& a, double t_a, const ExtendedCurve& b, double t_b,
                                              double tolerance) {
  for (int step = 0; step < max_steps; ++step) {
    const Vec2 gap = b.point(t_b) - a.point(t_a), da = a.derivative(t_a), db = b.derivative(t_b);
    if (norm(gap) <= tolerance) return ExtendedCrossing{t_a, t_b, a.point(t_a)};
    const double sine = cross(da, db);
    if (!(std::abs(sine) > 1e-12 * norm(da) * norm(db))) return std::nullopt;
    t_a += cross(gap, db) / sine;
    t_b += cross(gap, da) / sine;
  }
  return std::nullopt;
}

}  // namespace quadrille::offset
