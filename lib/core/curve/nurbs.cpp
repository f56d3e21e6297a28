#include "curve/nurbs.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/move_ends.hpp"
#include "curve/span.hpp"

namespace quadrille::curve {
namespace {

Vec2 projected(Homogeneous h) { return {h.x / h.w, h.y / h.w}; }

// De Boor's last step joins two points: the curve is on their segment, at the fraction u, the derivative along it.
struct LastSegment {
  Homogeneous a, b;
  double u;

  double weight() const { return (1 - u) * a.w + u * b.w; }
};

LastSegment last_segment(const Nurbs& curve, int k, double t) {
  return with_degree(curve.degree, [&](auto p) -> LastSegment {
    LocalPoles d = local_poles(curve, k, p);
    for (int r = 1; r < p; ++r)
      for (int j = p; j >= r; --j) {
        const double low = curve.knots[k - p + j], high = curve.knots[k + 1 + j - r];
        const double u = (t - low) / (high - low), v = 1 - u;
        d[j] = {v * d[j - 1].x + u * d[j].x, v * d[j - 1].y + u * d[j].y, v * d[j - 1].w + u * d[j].w};
      }
    return {d[p - 1], d[p], (t - curve.knots[k]) / (curve.knots[k + 1] - curve.knots[k])};
  });
}

Vec2 point_on(const LastSegment& s) {
  const double w = s.weight();
  return {((1 - s.u) * s.a.x + s.u * s.b.x) / w, ((1 - s.u) * s.a.y + s.u * s.b.y) / w};
}

// (A' w - A w') / w^2 with A' = p (b - a) / h, w' likewise, is p / h (a.w b - b.w a) / w^2.
Vec2 derivative_on(const LastSegment& s, int degree, double span) {
  const double w = s.weight(), scale = degree / (span * w * w);
  return {scale * (s.a.w * s.b.x - s.b.w * s.a.x), scale * (s.a.w * s.b.y - s.b.w * s.a.y)};
}

// The piece on span k at t and its derivatives up to the third.
std::array<Homogeneous, 4> homogeneous_derivatives(const Nurbs& curve, int k, double t) {
  std::array<Homogeneous, 4> a{};
  with_degree(curve.degree, [&](auto p) {
    LocalPoles d = local_poles(curve, k, p);
    for (int n = 0; n <= std::min<int>(3, p); ++n) {
      if (n > 0) differentiate(curve, k, p - n + 1, d);
      a[n] = de_boor(curve, k, p - n, d, [t](int) { return t; });
    }
  });
  return a;
}

Vec2 vec(Homogeneous h) { return {h.x, h.y}; }

Bend bend_of(const std::array<Vec2, 4>& d) {
  const double speed2 = norm2(d[1]), turn = cross(d[1], d[2]);
  if (speed2 == 0) return {};
  return {turn / std::pow(speed2, 1.5),
          (cross(d[1], d[3]) * speed2 - 3 * turn * dot(d[1], d[2])) / (speed2 * speed2 * speed2)};
}

/// Whether the curve is less than C3 between `before` and `after`: the same knot, or both ends of a closed curve.
bool is_break(const Nurbs& curve, double before, double after, double length, double tol) {
  const auto left = derivatives(curve, before, true), right = derivatives(curve, after, false);
  const Vec2 a = tangent(curve, before, true), b = tangent(curve, after, false);
  if (std::abs(std::atan2(cross(a, b), dot(a, b))) > tol) return true;
  if (norm2(left[1]) == 0 || norm2(right[1]) == 0) return true;
  const Bend before_it = bend_of(left), after_it = bend_of(right);
  const double k = std::max({std::abs(before_it.curvature), std::abs(after_it.curvature), 1 / length});
  if (std::abs(before_it.curvature - after_it.curvature) > tol * k) return true;
  const double slope = std::max({std::abs(before_it.slope), std::abs(after_it.slope), k * k});
  return std::abs(before_it.slope - after_it.slope) > tol * slope;
}

/// The first of the longest spans [knots[j], knots[j + 1]] with j from first to last.
int longest_span(const std::vector<double>& knots, int first, int last) {
  int longest = first;
  for (int j = first + 1; j <= last; ++j)
    if (knots[j + 1] - knots[j] > knots[longest + 1] - knots[longest]) longest = j;
  return longest;
}

}  // namespace

Vec2 point(const Nurbs& curve, double t) {
  // Returns the end poles bit for bit; (w x) / w does not always round to x.
  if (t <= curve.begin()) return curve.poles.front();
  if (t >= curve.end()) return curve.poles.back();
  const int k = find_span(curve, t);
  return with_degree(curve.degree, [&](auto p) {
    return projected(de_boor(curve, k, p, local_poles(curve, k, p), [t](int) { return t; }));
  });
}

Vec2 derivative(const Nurbs& curve, double t, bool from_left) {
  const double s = std::clamp(t, curve.begin(), curve.end());
  const int k = find_span(curve, s, from_left);
  return derivative_on(last_segment(curve, k, s), curve.degree, curve.knots[k + 1] - curve.knots[k]);
}

PointAndDerivative point_and_derivative(const Nurbs& curve, double t) {
  const double s = std::clamp(t, curve.begin(), curve.end());
  const int k = find_span(curve, s);
  const LastSegment last = last_segment(curve, k, s);
  const Vec2 x = s == curve.begin() ? curve.poles.front() : s == curve.end() ? curve.poles.back() : point_on(last);
  return {x, derivative_on(last, curve.degree, curve.knots[k + 1] - curve.knots[k])};
}

std::array<Vec2, 4> derivatives(const Nurbs& curve, double t, bool from_left) {
  const double s = std::clamp(t, curve.begin(), curve.end());
  const int k = find_span(curve, s, from_left);
  const std::array<Homogeneous, 4> a = homogeneous_derivatives(curve, k, s);
  const double w = a[0].w;
  std::array<Vec2, 4> c;
  c[0] = s == curve.begin() ? curve.poles.front() : s == curve.end() ? curve.poles.back() : projected(a[0]);
  c[1] = (vec(a[1]) - a[1].w * c[0]) / w;
  c[2] = (vec(a[2]) - 2 * a[1].w * c[1] - a[2].w * c[0]) / w;
  c[3] = (vec(a[3]) - 3 * a[1].w * c[2] - 3 * a[2].w * c[1] - a[3].w * c[0]) / w;
  return c;
}

Vec2 tangent(const Nurbs& curve, double t, bool from_left) {
  const Vec2 first = derivative(curve, t, from_left);
  const double range = curve.end() - curve.begin();
  // The size of the whole curve is computed only if the derivative is small relative to a distance of two of its poles.
  if (norm(first) * range > 1e-6 * distance(curve.poles.front(), curve.poles[curve.poles.size() / 2]))
    return normalized(first);
  const auto d = derivatives(curve, t, from_left);
  const double negligible = 1e-11 * polygon_length(curve);
  // Where C' vanishes, C'(t -+ h) = -+ h C'' + h^2 / 2 C''' ...: the sign alternates on the left side.
  const bool left = from_left || t >= curve.end();
  if (norm(d[1]) * range > negligible) return normalized(d[1]);
  if (norm(d[2]) * range * range > negligible) return normalized(left ? -d[2] : d[2]);
  if (norm(d[3]) > 0) return normalized(d[3]);
  throw ComputeError("a curve has no tangent: it is a single point");
}

Bend bend(const Nurbs& curve, double t, bool from_left) { return bend_of(derivatives(curve, t, from_left)); }

double curvature(const Nurbs& curve, double t, bool from_left) { return bend(curve, t, from_left).curvature; }

Nurbs reversed(const Nurbs& curve) {
  Nurbs r = curve;
  const double a = curve.begin(), b = curve.end();
  std::reverse(r.poles.begin(), r.poles.end());
  std::reverse(r.weights.begin(), r.weights.end());
  std::reverse(r.knots.begin(), r.knots.end());
  for (double& knot : r.knots) knot = knot == a ? b : knot == b ? a : a + (b - knot);
  return r;
}

Nurbs trimmed(const Nurbs& curve, double t0, double t1) {
  if (!(t0 < t1)) throw Defect("trimmed: empty interval");
  t0 = std::max(t0, curve.begin()), t1 = std::min(t1, curve.end());
  if (t0 == curve.begin() && t1 == curve.end()) return curve;
  const int p = curve.degree;
  const double negligible = 1e-13 * (curve.end() - curve.begin());
  Nurbs part;
  part.degree = p;
  part.knots.reserve(curve.knots.size() + 2 * (p + 1));
  part.knots.assign(p + 1, t0);
  for (const double knot : curve.knots)
    if (knot > t0 + negligible && knot < t1 - negligible) part.knots.push_back(knot);
  part.knots.insert(part.knots.end(), p + 1, t1);

  // Pole i is the blossom, at its p inner knots, of any polynomial piece that depends on it: of the longest, because a
  // knot may lie next to t0 or t1, and what is extrapolated from a tiny piece is noise.
  const int num_poles = static_cast<int>(part.knots.size()) - p - 1;
  part.poles.reserve(num_poles);
  part.weights.reserve(num_poles);
  for (int i = 0; i < num_poles; ++i) {
    const int j = longest_span(part.knots, std::max(i, p), std::min(i + p, num_poles - 1));
    const int k = find_span(curve, (part.knots[j] + part.knots[j + 1]) / 2);
    const Homogeneous h = de_boor(curve, k, p, local_poles(curve, k, p), [&](int r) { return part.knots[i + r]; });
    part.poles.push_back(projected(h));
    part.weights.push_back(h.w);
  }
  part.poles.front() = point(curve, t0);
  part.poles.back() = point(curve, t1);
  return part;
}

Nurbs with_ends(Nurbs curve, Vec2 start, Vec2 end) {
  if (curve.degree == 1 && curve.poles.size() == 2) return segment(start, end);
  move_ends(curve.poles, start, end);
  return curve;
}

double polygon_length(const Nurbs& curve) {
  double length = 0;
  for (size_t i = 1; i < curve.poles.size(); ++i) length += distance(curve.poles[i - 1], curve.poles[i]);
  return length;
}

Nurbs segment(Vec2 a, Vec2 b) {
  const double length = distance(a, b);
  return {1, {0, 0, length, length}, {a, b}, {1, 1}};
}

Nurbs circular_arc(Vec2 centre, double radius, double angle0, double angle1) {
  const double sweep = std::abs(angle1 - angle0);
  if (!(sweep > 0)) throw Defect("circular_arc: empty arc");
  // A sweep of 90 degrees is one piece, even with a rounding error.
  const int pieces = std::max(1, static_cast<int>(std::ceil(sweep / half_pi * (1 - 1e-12))));
  const double step = (angle1 - angle0) / pieces, w = std::cos(step / 2);
  Nurbs arc;
  arc.degree = 2;
  arc.knots = {0, 0, 0};
  for (int i = 0; i <= pieces; ++i) {
    const double angle = i == pieces ? angle1 : angle0 + i * step;
    if (i > 0) {
      arc.poles.push_back(centre + radius / w * unit(angle - step / 2));
      arc.weights.push_back(w);
      const double knot = i == pieces ? sweep : std::abs(step) * i;
      arc.knots.insert(arc.knots.end(), i == pieces ? 3 : 2, knot);
    }
    arc.poles.push_back(centre + radius * unit(angle));
    arc.weights.push_back(1);
  }
  return arc;
}

Nurbs cubic_spline(const std::vector<double>& parameters, const std::vector<Vec2>& points, Vec2 start_derivative,
                   Vec2 end_derivative) {
  const int n = static_cast<int>(points.size());
  if (n < 2 || parameters.size() != points.size()) throw Defect("cubic_spline: needs two points or more");
  Nurbs s;
  s.degree = 3;
  s.knots.assign(3, parameters.front());
  s.knots.insert(s.knots.end(), parameters.begin(), parameters.end());
  s.knots.insert(s.knots.end(), 3, parameters.back());
  s.weights.assign(n + 2, 1.0);
  s.poles.assign(n + 2, Vec2{});
  const auto& u = s.knots;
  s.poles[0] = points.front();
  s.poles[1] = points.front() + (u[4] - u[3]) / 3 * start_derivative;
  s.poles[n] = points.back() - (u[n + 2] - u[n + 1]) / 3 * end_derivative;
  s.poles[n + 1] = points.back();

  // At an inner parameter three basis functions are not 0: a tridiagonal system for poles 2 .. n-1 (Thomas algorithm).
  std::vector<double> upper(n + 2, 0.0);
  for (int i = 1; i + 1 < n; ++i) {
    const int k = i + 3;
    const double before = u[k] - u[k - 1], after = u[k + 1] - u[k], both = u[k + 1] - u[k - 1];
    const double low = after * after / (both * (u[k + 1] - u[k - 2]));
    const double high = before * before / (both * (u[k + 2] - u[k - 1]));
    const double diagonal = 1 - low - high - (i > 1 ? low * upper[i] : 0);
    Vec2 rhs = points[i] - low * s.poles[i];
    if (i + 2 == n) rhs -= high * s.poles[n];
    upper[i + 1] = high / diagonal;
    s.poles[i + 1] = rhs / diagonal;
  }
  for (int i = n - 2; i >= 2; --i) s.poles[i] -= upper[i] * s.poles[i + 1];
  return s;
}

std::vector<double> smoothness_breaks(const Nurbs& curve, double relative_tol) {
  std::vector<double> breaks;
  const double length = polygon_length(curve);
  for (size_t i = curve.degree + 1; i + curve.degree + 1 < curve.knots.size(); ++i) {
    const double knot = curve.knots[i];
    if (knot == curve.knots[i - 1] || knot >= curve.end()) continue;
    if (is_break(curve, knot, knot, length, relative_tol)) breaks.push_back(knot);
  }
  return breaks;
}

bool has_smooth_seam(const Nurbs& curve, double relative_tol) {
  const double length = polygon_length(curve);
  return distance(curve.poles.front(), curve.poles.back()) <= relative_tol * length &&
         !is_break(curve, curve.end(), curve.begin(), length, relative_tol);
}

}  // namespace quadrille::curve
