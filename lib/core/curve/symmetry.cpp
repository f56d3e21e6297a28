#include "curve/symmetry.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/angle.hpp"
#include "curve/face_boundary.hpp"
#include "curve/gauss.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::curve {

namespace {

constexpr double radians_per_diameter = 10;  // tolerance of the angles of crossings

/// Centroid of the area: 3 A c = oint x (x cross dx), 2 A = oint x cross dx, relative to a point of the boundary.
Vec2 centroid(const CadFace& face) {
  const Vec2 base = face.joints[0].position;
  double twice_area = 0;
  Vec2 moment;
  for (const Nurbs& curve : face.curves)
    for_each_span(curve, [&](double a, double b) {
      const auto area_rate = [&](double t) { return cross(point(curve, t) - base, derivative(curve, t)); };
      twice_area += gauss_integral(area_rate, a, b);
      moment += gauss_integral([&](double t) { return area_rate(t) * (point(curve, t) - base); }, a, b);
    });
  return base + moment * (2.0 / 3.0) / twice_area;
}

/// The distance from the centre along a knot span, at equal steps.
struct RadiusSamples {
  int curve;
  std::vector<double> t, radius;
};

std::vector<RadiusSamples> radius_samples(const CadFace& face, Vec2 centre) {
  constexpr int steps = 16;
  std::vector<RadiusSamples> all;
  for (int c = 0; c < face.num_curves(); ++c)
    for_each_span(face.curves[c], [&](double a, double b) {
      RadiusSamples span{c, {}, {}};
      for (int i = 0; i <= steps; ++i) {
        span.t.push_back(i == steps ? b : a + (b - a) * i / steps);
        span.radius.push_back(distance(point(face.curves[c], span.t.back()), centre));
      }
      all.push_back(std::move(span));
    });
  return all;
}

/// The extreme radius between two parameters; sign = 1: the greatest, sign = -1: the least.
double extreme_radius(const Nurbs& curve, Vec2 centre, double a, double b, int sign) {
  for (int i = 0; i < 40; ++i) {
    const double left = a + (b - a) / 3, right = b - (b - a) / 3;
    const bool rises = sign * distance(point(curve, left), centre) < sign * distance(point(curve, right), centre);
    (rises ? a : b) = rises ? left : right;
  }
  return distance(point(curve, (a + b) / 2), centre);
}

/// Radii at which a circle about the centre would touch the boundary or pass through an end of a span; ascending.
std::vector<double> critical_radii(const CadFace& face, Vec2 centre, const std::vector<RadiusSamples>& spans) {
  std::vector<double> radii;
  for (const RadiusSamples& s : spans) {
    radii.push_back(s.radius.front());
    radii.push_back(s.radius.back());
    for (std::size_t i = 1; i + 1 < s.radius.size(); ++i)
      for (const int sign : {1, -1})
        if (sign * s.radius[i] >= sign * s.radius[i - 1] && sign * s.radius[i] >= sign * s.radius[i + 1])
          radii.push_back(extreme_radius(face.curves[s.curve], centre, s.t[i - 1], s.t[i + 1], sign));
  }
  std::sort(radii.begin(), radii.end());
  return radii;
}

/// A point at which the boundary crosses a circle about the centre.
struct Crossing {
  double angle;     ///< in [0, 2 pi)
  bool is_outward;  ///< along the curve
};

std::vector<Crossing> crossings(const CadFace& face, Vec2 centre, const std::vector<RadiusSamples>& spans,
                                double radius) {
  std::vector<Crossing> found;
  for (const RadiusSamples& s : spans)
    for (std::size_t i = 1; i < s.t.size(); ++i) {
      const bool is_outward = s.radius[i - 1] < radius;
      if (is_outward == (s.radius[i] < radius)) continue;
      double a = s.t[i - 1], b = s.t[i];
      for (int k = 0; k < 60; ++k) {
        const double middle = (a + b) / 2;
        ((distance(point(face.curves[s.curve], middle), centre) < radius) == is_outward ? a : b) = middle;
      }
      found.push_back({wrap_two_pi(angle_of(point(face.curves[s.curve], (a + b) / 2) - centre)), is_outward});
    }
  return found;
}

/// Crossings of the circle whose radius is farthest from any tangency: every isometry permutes them. Empty if all loops
/// are circles about the centre.
std::vector<Crossing> best_crossings(const CadFace& face, Vec2 centre, double tolerance) {
  const std::vector<RadiusSamples> spans = radius_samples(face, centre);
  const std::vector<double> radii = critical_radii(face, centre, spans);
  std::vector<std::pair<double, double>> gaps;  // width, middle
  for (std::size_t i = 1; i < radii.size(); ++i)
    gaps.push_back({radii[i] - radii[i - 1], (radii[i] + radii[i - 1]) / 2});
  std::stable_sort(gaps.begin(), gaps.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  for (const auto& [width, middle] : gaps) {
    if (width < 2 * tolerance * face.diameter) break;
    std::vector<Crossing> found = crossings(face, centre, spans, middle);
    if (!found.empty()) return found;
  }
  return {};
}

/// Mean signed angle between the images of the crossings and the crossings next to them; std::nullopt if an image is at
/// no crossing.
std::optional<double> mean_miss(const Isometry& g, const std::vector<Crossing>& crossings, double angle_tol) {
  double sum = 0;
  for (const Crossing& c : crossings) {
    const double image = g.is_mirrored ? g.angle - c.angle : g.angle + c.angle;
    const auto met = std::find_if(crossings.begin(), crossings.end(), [&](const Crossing& other) {
      return (other.is_outward == c.is_outward) != g.is_mirrored && std::abs(wrap_pi(other.angle - image)) < angle_tol;
    });
    if (met == crossings.end()) return {};
    sum += wrap_pi(met->angle - image);
  }
  return sum / static_cast<double>(crossings.size());
}

/// Whether an isometry maps sampled points of all curves onto the boundary.
class BoundaryMap {
 public:
  BoundaryMap(const CadFace& face, double tolerance)
      : boundary_(face.curves), tol_(tolerance * face.diameter), angle_tol_(radians_per_diameter * tolerance) {
    constexpr int steps = 5;  // odd, and different from the samples of the projection
    for (const Nurbs& curve : face.curves)
      for_each_span(curve, [&](double a, double b) {
        for (int i = 0; i < steps; ++i) points_.push_back(point(curve, a + (b - a) * i / steps));
      });
  }
  /// Between crossings: only to rule out candidates.
  double angle_tol() const { return angle_tol_; }
  bool is_onto(const Isometry& g) const {
    return std::all_of(points_.begin(), points_.end(),
                       [&](Vec2 x) { return boundary_.nearest(g(x)).distance <= tol_; });
  }

 private:
  CurveTree boundary_;
  double tol_, angle_tol_;
  std::vector<Vec2> points_;
};

/// The number of rotations.
int rotation_order(Vec2 centre, const std::vector<Crossing>& crossings, const BoundaryMap& boundary) {
  const int most = static_cast<int>(crossings.size()) / 2;  // as many crossings are outward as inward
  for (int n = most; n > 1; --n) {
    const Isometry g{centre, 2 * pi / n, false};
    if (most % n == 0 && mean_miss(g, crossings, boundary.angle_tol()) && boundary.is_onto(g)) return n;
  }
  return 1;
}

/// The angle of one mirrored isometry: from one pair of crossings, then improved by the mean over all.
std::optional<double> mirror_angle(Vec2 centre, int n, const std::vector<Crossing>& crossings,
                                   const BoundaryMap& boundary) {
  const double period = 2 * pi / n;
  std::vector<double> tried;
  for (const Crossing& other : crossings) {
    if (other.is_outward == crossings[0].is_outward) continue;
    const double sum = crossings[0].angle + other.angle;
    Isometry g{centre, sum - period * std::floor(sum / period), true};
    const bool is_known = std::any_of(tried.begin(), tried.end(), [&](double t) {
      return std::abs(std::remainder(t - g.angle, period)) < boundary.angle_tol();
    });
    if (is_known) continue;
    tried.push_back(g.angle);
    const std::optional<double> miss = mean_miss(g, crossings, boundary.angle_tol());
    if (!miss) continue;
    g.angle += *miss;
    if (boundary.is_onto(g)) return g.angle;
  }
  return {};
}

std::vector<Isometry> group(Vec2 centre, int n, std::optional<double> first_mirror) {
  std::vector<Isometry> all;
  for (int k = 0; k < n; ++k) all.push_back({centre, 2 * pi * k / n, false});
  for (int k = 0; k < n && first_mirror; ++k) all.push_back({centre, *first_mirror + 2 * pi * k / n, true});
  return all;
}

}  // namespace

Vec2 Isometry::turned(Vec2 d) const {
  if (is_mirrored) d.y = -d.y;
  const Vec2 r = unit(angle);
  return {r.x * d.x - r.y * d.y, r.y * d.x + r.x * d.y};
}

Vec2 Isometry::operator()(Vec2 x) const {
  if (angle == 0 && !is_mirrored) return x;
  return centre + turned(x - centre);
}

std::vector<Isometry> symmetries(const CadFace& face, double tolerance) {
  const Vec2 centre = centroid(face);
  const std::vector<Crossing> crossed = best_crossings(face, centre, tolerance);
  if (crossed.empty()) {
    const double axis = wrap_two_pi(2 * angle_of(face.joints[0].position - centre));
    return group(centre, 4, axis - half_pi * std::floor(axis / half_pi));
  }
  const BoundaryMap boundary(face, tolerance);
  const int n = rotation_order(centre, crossed, boundary);
  return group(centre, n, mirror_angle(centre, n, crossed, boundary));
}

}  // namespace quadrille::curve
