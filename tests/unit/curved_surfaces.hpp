#pragma once
// Exact rational surfaces for tests: profiles in the plane y = 0 (x is the distance from the axis z), revolved about z.

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "model/chart.hpp"

namespace quadrille::tests {

/// A straight line, parameter 0 to 1.
inline SpaceCurve line(Vec3 a, Vec3 b) { return {1, {0, 0, 1, 1}, {a, b}, {1, 1}}; }

/// An arc in the plane y = 0 about (centre, 0, 0), from angle0 to angle1 (radians, from the x axis towards z), in
/// pieces of equal angle, at most a quarter turn each; parameter = angle.
inline SpaceCurve profile_arc(double centre, double radius, double angle0, double angle1) {
  const int pieces =
      std::max(1, static_cast<int>(std::ceil(std::abs(angle1 - angle0) / (std::numbers::pi / 2) - 1e-9)));
  const double step = (angle1 - angle0) / pieces, w = std::cos(step / 2);
  SpaceCurve arc{2, {angle0, angle0, angle0}, {}, {}};
  for (int i = 0; i <= 2 * pieces; ++i) {
    const double angle = angle0 + step * i / 2, r = i % 2 == 0 ? radius : radius / w;
    arc.poles.push_back({centre + r * std::cos(angle), 0, r * std::sin(angle)});
    arc.weights.push_back(i % 2 == 0 ? 1 : w);
    if (i % 2 == 0 && i > 0) arc.knots.insert(arc.knots.end(), i == 2 * pieces ? 3 : 2, angle);
  }
  return arc;
}

/// u: the angle about z, from `begin` to `end`, counter-clockwise; v: the profile's parameter. The normal X_u x X_v
/// points away from the axis where the profile rises.
inline NurbsSurface revolved(const SpaceCurve& profile, double begin = 0, double end = 2 * std::numbers::pi) {
  const SpaceCurve circle = profile_arc(0, 1, begin, end);  // x, z: cosine and sine
  NurbsSurface s;
  s.degree_u = 2, s.knots_u = circle.knots;
  s.degree_v = profile.degree, s.knots_v = profile.knots;
  s.is_closed_u = end - begin > 6.28;
  for (std::size_t i = 0; i < circle.poles.size(); ++i)
    for (std::size_t j = 0; j < profile.poles.size(); ++j) {
      const Vec3 c = circle.poles[i], p = profile.poles[j];
      s.poles.push_back({p.x * c.x, p.x * c.z, p.z});
      s.weights.push_back(circle.weights[i] * profile.weights[j]);
    }
  return s;
}

/// A sphere about the origin; poles of the parametrisation at z = -radius and z = radius.
inline NurbsSurface sphere(double radius) {
  return revolved(profile_arc(0, radius, -std::numbers::pi / 2, std::numbers::pi / 2));
}
inline NurbsSurface cylinder(double radius, double height) {
  return revolved(line({radius, 0, 0}, {radius, 0, height}));
}
/// From the apex at the origin to the circle of `radius` at z = height.
inline NurbsSurface cone(double radius, double height) { return revolved(line({0, 0, 0}, {radius, 0, height})); }
inline NurbsSurface torus(double major, double minor) {
  NurbsSurface s = revolved(profile_arc(major, minor, 0, 2 * std::numbers::pi));
  s.is_closed_v = true;
  return s;
}

}  // namespace quadrille::tests
