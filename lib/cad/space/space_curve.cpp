#include "space/space_curve.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/vec3.hpp"
#include "curve/move_ends.hpp"
#include "curve/nurbs.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::space {

namespace {

// Knot insertion does not mix coordinates: the images of a curve in two planes say all.
Nurbs image(const SpaceCurve& curve, double Vec3::*y) {
  Nurbs result{curve.degree, curve.knots, {}, curve.weights};
  for (const Vec3& pole : curve.poles) result.poles.push_back({pole.x, pole.*y});
  return result;
}

}  // namespace

SpaceCurve combined(const Nurbs& xy, const Nurbs& xz) {
  SpaceCurve curve{xy.degree, xy.knots, {}, xy.weights};
  for (std::size_t i = 0; i < xy.poles.size(); ++i)
    curve.poles.push_back({xy.poles[i].x, xy.poles[i].y, xz.poles[i].y});
  return curve;
}

SpaceCurve trimmed(const SpaceCurve& curve, double t0, double t1) {
  return combined(curve::trimmed(image(curve, &Vec3::y), t0, t1), curve::trimmed(image(curve, &Vec3::z), t0, t1));
}

SpaceCurve with_ends(SpaceCurve curve, Vec3 start, Vec3 end) {
  curve::move_ends(curve.poles, start, end);
  return curve;
}

std::vector<double> tangent_jumps(const SpaceCurve& curve) {
  constexpr double smallest_jump = 1e-9;  // smaller ones are rounding errors of the decimal numbers in a text file
  std::vector<double> result;
  for (std::size_t k = curve.degree + 1; k + curve.degree + 1 < curve.knots.size(); ++k) {
    const double t = curve.knots[k];
    if (t == curve.knots[k - 1]) continue;
    if (std::count(curve.knots.begin(), curve.knots.end(), t) < curve.degree) continue;
    const Vec3 a = surface::derivatives(curve, t, true)[1], b = surface::derivatives(curve, t)[1];
    if (std::atan2(norm(cross(a, b)), dot(a, b)) > smallest_jump) result.push_back(t);
  }
  return result;
}

double polygon_length(const SpaceCurve& curve) {
  double length = 0;
  for (std::size_t i = 1; i < curve.poles.size(); ++i) length += distance(curve.poles[i - 1], curve.poles[i]);
  return length;
}

}  // namespace quadrille::space
