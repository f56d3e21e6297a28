#include "draw/pixel_curve.hpp"

#include <algorithm>
#include <cmath>

namespace quadrille::draw {

namespace {

constexpr double tolerance = 0.05;  // pixels
constexpr int max_depth = 12;

struct Cubic {
  Vec2 a, b, c, d;
  Vec2 at(double s) const {
    const double r = 1 - s;
    return r * r * r * a + 3 * r * r * s * b + 3 * r * s * s * c + s * s * s * d;
  }
};

bool is_straight(const Cubic& cubic, const Vec2 samples[3]) {
  const Vec2 chord = cubic.d - cubic.a;
  const double length = norm(chord);
  const auto is_on_chord = [&](Vec2 p) {
    return length > 0 ? std::abs(cross(chord, p - cubic.a)) <= 0.5 * tolerance * length : p == cubic.a;
  };
  return std::all_of(samples, samples + 3, is_on_chord);
}

void append(PathData& path, const PixelCurve& curve, double t0, CurvePoint p0, double t1, CurvePoint p1, int depth) {
  const double third = (t1 - t0) / 3;
  const Cubic cubic{p0.position, p0.position + third * p0.derivative, p1.position - third * p1.derivative, p1.position};
  Vec2 samples[3];
  double error = 0;
  CurvePoint middle;
  for (int i = 0; i < 3; ++i) {
    const double s = 0.25 * (i + 1);
    const CurvePoint p = curve(t0 + s * (t1 - t0));
    if (i == 1) middle = p;
    samples[i] = p.position;
    error = std::max(error, distance(p.position, cubic.at(s)));
  }
  if (is_straight(cubic, samples)) return path.line_to(p1.position);
  if (error < tolerance || depth == max_depth) return path.cubic_to(cubic.b, cubic.c, cubic.d);
  const double half = 0.5 * (t0 + t1);
  append(path, curve, t0, p0, half, middle, depth + 1);
  append(path, curve, half, middle, t1, p1, depth + 1);
}

}  // namespace

void append_curve(PathData& path, const PixelCurve& curve, double t0, double t1) {
  append(path, curve, t0, curve(t0), t1, curve(t1), 0);
}

}  // namespace quadrille::draw
