#include "surface/nurbs_surface.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.hpp"

namespace quadrille::surface {
namespace {

constexpr int max_degree = 25;  // the largest that the CAD kernel and the formats allow

/// The span k with knots[k] <= t < knots[k + 1] (from the left: knots[k] < t <= knots[k + 1]); never an empty one.
int find_span(const std::vector<double>& knots, int degree, double t, bool from_left) {
  const auto begin = knots.begin() + degree, end = knots.end() - degree - 1;
  const auto above = from_left ? std::lower_bound(begin, end, t) : std::upper_bound(begin, end, t);
  const auto first = std::upper_bound(begin, end, *begin), last = std::lower_bound(begin, end, *end);
  return static_cast<int>(std::clamp(above, first, last) - knots.begin()) - 1;
}

/// Values of the degree + 1 basis functions that do not vanish on a span, and their first two derivatives. Only what
/// is asked for is set: most of the time of an evaluation would be spent on zeros beyond.
using Values = std::array<double, max_degree + 1>;
using Basis = std::array<Values, 3>;

/// d: derivatives of the functions of degree p, from those of degree p - 1 (The NURBS Book, eq. 2.7).
void raise(const std::vector<double>& knots, int k, int p, const Values& f, Values& d) {
  std::fill_n(d.begin(), p + 1, 0.0);
  for (int r = 0; r < p; ++r) {
    const double slope = p * f[r] / (knots[k + r + 1] - knots[k + 1 - p + r]);
    d[r] -= slope;
    d[r + 1] += slope;
  }
}

// Cox and de Boor's recursion, from degree to degree; the derivative of N_i,p is p times the difference of N_i,p-1 over
// their knots, twice for the second.
void basis_functions(const std::vector<double>& knots, int degree, int k, double t, int highest, Basis& basis) {
  Values& n = basis[0];
  Values lower;  // of degree - 2, then of degree - 1
  n[0] = 1;
  for (int p = 1; p <= degree; ++p) {
    if (p == degree - 1 && highest > 1) std::copy_n(n.begin(), p, lower.begin());
    if (p == degree && highest > 0) raise(knots, k, p, n, basis[1]);
    double saved = 0;
    for (int r = 0; r < p; ++r) {
      const double right = knots[k + r + 1], left = knots[k + 1 - p + r], value = n[r] / (right - left);
      n[r] = saved + (right - t) * value;
      saved = (t - left) * value;
    }
    n[p] = saved;
  }
  if (highest < 2) return;
  if (degree == 1) {
    basis[2][0] = basis[2][1] = 0;
    return;
  }
  Values slopes;
  raise(knots, k, degree - 1, lower, slopes);
  raise(knots, k, degree, slopes, basis[2]);
}

struct Homogeneous {
  Vec3 x;
  double w = 0;

  void add(double factor, Vec3 pole, double weight) { x += factor * weight * pole, w += factor * weight; }
};

double in_interval(double t, const std::vector<double>& knots, bool is_closed) {
  const double begin = knots.front(), end = knots.back();
  if (t >= begin && t <= end) return t;
  if (!is_closed) return std::clamp(t, begin, end);
  return std::clamp(t - std::floor((t - begin) / (end - begin)) * (end - begin), begin, end);
}

/// All derivatives of order i in u and j in v with i + j <= 2, at [i][j], in homogeneous coordinates.
std::array<std::array<Homogeneous, 3>, 3> homogeneous(const NurbsSurface& s, Vec2 uv, int highest) {
  const int ku = find_span(s.knots_u, s.degree_u, uv.x, false), kv = find_span(s.knots_v, s.degree_v, uv.y, false);
  Basis nu, nv;
  basis_functions(s.knots_u, s.degree_u, ku, uv.x, highest, nu);
  basis_functions(s.knots_v, s.degree_v, kv, uv.y, highest, nv);
  std::array<std::array<Homogeneous, 3>, 3> a{};
  const int width = s.num_poles_v();
  for (int i = 0; i <= s.degree_u; ++i) {
    std::array<Homogeneous, 3> row{};  // sums over v of the derivatives in v
    for (int j = 0; j <= s.degree_v; ++j) {
      const int pole = (ku - s.degree_u + i) * width + kv - s.degree_v + j;
      for (int d = 0; d <= highest; ++d) row[d].add(nv[d][j], s.poles[pole], s.weights[pole]);
    }
    for (int du = 0; du <= highest; ++du)
      for (int dv = 0; du + dv <= highest; ++dv) {
        a[du][dv].x += nu[du][i] * row[dv].x;
        a[du][dv].w += nu[du][i] * row[dv].w;
      }
  }
  return a;
}

}  // namespace

std::array<Vec3, 3> derivatives(const SpaceCurve& curve, double t, bool from_left) {
  t = std::clamp(t, curve.begin(), curve.end());
  const int k = find_span(curve.knots, curve.degree, t, from_left);
  Basis n;
  basis_functions(curve.knots, curve.degree, k, t, 2, n);
  std::array<Homogeneous, 3> a{};
  for (int i = 0; i <= curve.degree; ++i)
    for (int d = 0; d < 3; ++d)
      a[d].add(n[d][i], curve.poles[k - curve.degree + i], curve.weights[k - curve.degree + i]);
  const Vec3 x = a[0].x / a[0].w, first = (a[1].x - a[1].w * x) / a[0].w;
  return {x, first, (a[2].x - 2 * a[1].w * first - a[2].w * x) / a[0].w};
}

Vec3 point(const SpaceCurve& curve, double t) {
  // (w x) / w does not always round to x.
  if (t <= curve.begin()) return curve.poles.front();
  if (t >= curve.end()) return curve.poles.back();
  return derivatives(curve, t)[0];
}

SpaceCurve reversed(const SpaceCurve& curve) {
  SpaceCurve result = curve;
  std::reverse(result.poles.begin(), result.poles.end());
  std::reverse(result.weights.begin(), result.weights.end());
  for (std::size_t i = 0; i < curve.knots.size(); ++i)
    result.knots[i] = curve.begin() + (curve.end() - curve.knots[curve.knots.size() - 1 - i]);
  return result;
}

Vec2 in_domain(const NurbsSurface& surface, Vec2 uv) {
  return {in_interval(uv.x, surface.knots_u, surface.is_closed_u),
          in_interval(uv.y, surface.knots_v, surface.is_closed_v)};
}

// The quotient rule, The NURBS Book, eq. 4.20.
SurfacePoint evaluate(const NurbsSurface& surface, Vec2 uv) {
  const auto a = homogeneous(surface, in_domain(surface, uv), 2);
  const double w = a[0][0].w;
  SurfacePoint p;
  p.x = a[0][0].x / w;
  p.xu = (a[1][0].x - a[1][0].w * p.x) / w;
  p.xv = (a[0][1].x - a[0][1].w * p.x) / w;
  p.xuu = (a[2][0].x - 2 * a[1][0].w * p.xu - a[2][0].w * p.x) / w;
  p.xvv = (a[0][2].x - 2 * a[0][1].w * p.xv - a[0][2].w * p.x) / w;
  p.xuv = (a[1][1].x - a[1][0].w * p.xv - a[0][1].w * p.xu - a[1][1].w * p.x) / w;
  return p;
}

Vec3 point(const NurbsSurface& surface, Vec2 uv) {
  const Homogeneous h = homogeneous(surface, in_domain(surface, uv), 0)[0][0];
  return h.x / h.w;
}

double greatest_curvature(const NurbsSurface& surface, Vec2 uv) {
  constexpr double degenerate = 1e-8;  // of the lengths of the derivatives
  const SurfacePoint p = evaluate(surface, uv);
  const Vec3 normal = cross(p.xu, p.xv);
  const double e = norm2(p.xu), f = dot(p.xu, p.xv), g = norm2(p.xv), area = norm(normal);
  if (!(area > degenerate * std::max(e, g))) return 0;
  const double l = dot(normal, p.xuu) / area, m = dot(normal, p.xuv) / area, n = dot(normal, p.xvv) / area;
  const double mean = (e * n - 2 * f * m + g * l) / (2 * area * area), gauss = (l * n - m * m) / (area * area);
  return std::abs(mean) + std::sqrt(std::max(0.0, mean * mean - gauss));
}

namespace {

/// Parameters in the domain with what is there.
struct ParameterPlace {
  Vec2 uv;
  SurfacePoint p;
};

/// Newton's method has no direction at a pole, a side whose points are one, and a wrong one beside it. If uv is not
/// much farther from a pole than from x: parameters as far off as x, on the side of x.
Vec2 beside_pole(const NurbsSurface& surface, Vec3 x, const ParameterPlace& place) {
  constexpr int num_directions = 32, num_distances = 6;
  constexpr double distance_ratio = 0.3;
  constexpr double part_of_turn = 0.125;  // which the way to x is at most along a parameter line for Newton's method
  const auto& [uv, p] = place;
  const double off = norm(x - p.x);
  const auto range = [](const std::vector<double>& knots) { return knots.back() - knots.front(); };
  const double width_u = norm(p.xu) * range(surface.knots_u), width_v = norm(p.xv) * range(surface.knots_v);
  if (part_of_turn * std::min(width_u, width_v) >= off) return uv;
  const bool is_u = width_u < width_v;  // the parameter along the side
  const std::vector<double>&along = is_u ? surface.knots_u : surface.knots_v,
        &across = is_u ? surface.knots_v : surface.knots_u;
  const double middle = (across.front() + across.back()) / 2, at = is_u ? uv.y : uv.x;
  const double speed = norm(is_u ? p.xv : p.xu), inwards = at < middle ? 1 : -1;
  Vec2 best = uv;
  double least = off;
  // x may lie above the surface: its foot is at any distance up to `off`.
  for (int k = 0; k < num_distances; ++k)
    for (int i = 0; i <= num_directions; ++i) {
      const double step = std::min(std::pow(distance_ratio, k) * off / speed, std::abs(middle - at));
      const double t = along.front() + range(along) * i / num_directions, inner = at + inwards * step;
      const Vec2 near = is_u ? Vec2{t, inner} : Vec2{inner, t};
      if (const double d = norm(point(surface, near) - x); d < least) best = near, least = d;
    }
  return best;
}

// Newton's method on f = |X - x|^2 / 2 with the Hessian H = [X_i . X_j + (X - x) . X_ij]. Where H is not positive
// definite, or a step makes f greater by more than round-off, a diagonal is added and grows (Levenberg). It is scaled
// by |X_u|, |X_v|, of which one vanishes at a pole.
// The last step is not made where steps shrink as those of Newton's method do and it would be round-off.
SurfaceProjection newton(const NurbsSurface& surface, Vec3 x, ParameterPlace& at) {
  constexpr int most_steps = 60;
  constexpr double first_damping = 1e-6, most_damping = 1e9, round_off = 1e-14;
  const double size = norm(x) + norm(surface.poles.front()), least_step = 4e-16 * size;
  bool is_converged = false;
  double damping = 0, last_step = 0;
  for (int step = 0; step < most_steps && !is_converged && damping < most_damping; ++step) {
    const SurfacePoint& p = at.p;
    const Vec3 r = p.x - x;
    const double pole = 1e-24 * (norm2(p.xu) + norm2(p.xv)), scale_u = norm2(p.xu) + pole, scale_v = norm2(p.xv) + pole;
    const double mixed = dot(p.xu, p.xv) + dot(r, p.xuv);
    const Mat2 h{scale_u * (1 + damping) + dot(r, p.xuu), mixed, mixed, scale_v * (1 + damping) + dot(r, p.xvv)};
    bool is_accepted = h.xx > 0 && det(h) > round_off * scale_u * scale_v;
    if (is_accepted) {
      const Vec2 next = in_domain(surface, at.uv - inverse(h) * Vec2{dot(r, p.xu), dot(r, p.xv)});
      const SurfacePoint q = evaluate(surface, next);
      is_accepted = norm2(q.x - x) <= norm2(r) + round_off * (norm2(r) + round_off * size * size);
      if (is_accepted) {
        const double length = norm(q.x - p.x);
        is_converged =
            length <= least_step || next == at.uv || (damping == 0 && length * length <= least_step * last_step);
        last_step = damping == 0 ? length : 0;
        at = {next, q};
      }
    }
    damping = is_accepted ? (damping > first_damping ? damping / 10 : 0) : std::max(10 * damping, first_damping);
  }
  return {at.uv, at.p.x, norm(at.p.x - x), is_converged};
}

}  // namespace

// Steps may end at a pole, too.
SurfaceProjection project(const NurbsSurface& surface, Vec3 x, Vec2 uv) {
  const auto from = [&](Vec2 start, ParameterPlace& at) {
    if (start != at.uv) at = {start, evaluate(surface, start)};
    return newton(surface, x, at);
  };
  ParameterPlace at{in_domain(surface, uv), {}};
  at.p = evaluate(surface, at.uv);
  const SurfaceProjection found = from(beside_pole(surface, x, at), at);
  const Vec2 beside = beside_pole(surface, x, at);
  if (beside == found.uv) return found;
  const SurfaceProjection other = from(beside, at);
  return other.distance < found.distance ? other : found;
}

}  // namespace quadrille::surface
