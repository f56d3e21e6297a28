#include "occ/surface_piece.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "curve/least_squares_spline.hpp"
#include "curve/nurbs.hpp"
#include "space/space_curve.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::occ {
namespace {

constexpr int num_samples = 64;     ///< of a piece: the parameters turn by less than half a period between two of them
constexpr double near_pole = 1e-3;  ///< of a piece: nearer to a pole its parameter is extrapolated

bool is_closed(const NurbsSurface& surface, Parameter p) {
  return p == Parameter::u ? surface.is_closed_u : surface.is_closed_v;
}

/// `value`, moved by whole periods to where it is nearest to `target`.
Vec2 nearest_period(const NurbsSurface& surface, Vec2 value, Vec2 target) {
  for (const Parameter p : both)
    if (const double length = period(surface, p); length > 0)
      part(value, p) += length * std::round((part(target, p) - part(value, p)) / length);
  return value;
}

/// The parameters along a piece, without jumps, from those of its start to those of its end. s: 0 to length.
class ParameterPath {
 public:
  using Raw = std::function<Vec2(double s)>;

  ParameterPath(const NurbsSurface& surface, Raw raw, double length, const SurfaceNode& start, const SurfaceNode& end)
      : surface_(surface), raw_(std::move(raw)), length_(length), free_start_(start.free), free_end_(end.free) {
    for (int i = 0; i <= num_samples; ++i) {
      const bool is_at_pole =
          (i == 0 && free_start_ != Parameter::none) || (i == num_samples && free_end_ != Parameter::none);
      const double s = is_at_pole ? length * (i == 0 ? near_pole : 1 - near_pole) : length * i / num_samples;
      const Vec2 uv = raw_(s);
      samples_.push_back(i == 0 ? uv : nearest_period(surface, uv, samples_.back()));
    }
    at_start_ = correction(start, 0), at_end_ = correction(end, length);
  }

  Vec2 operator()(double s) const {
    Vec2 uv = continuous(s) + (1 - s / length_) * at_start_ + (s / length_) * at_end_;
    extrapolate(free_start_, s, 0, uv);
    extrapolate(free_end_, s, length_, uv);
    return uv;
  }

  /// One-sided, at one of the ends.
  Vec2 slope(bool at_end) const {
    constexpr double share = 1e-4;
    const double h = at_end ? -share * length_ : share * length_, s = at_end ? length_ : 0;
    return (-3 * (*this)(s) + 4 * (*this)(s + h) - (*this)(s + 2 * h)) / (2 * h);
  }

  Vec2 sample(int i) const { return samples_[i]; }

 private:
  Vec2 continuous(double s) const {
    const double at = s / length_ * num_samples;
    const int i = std::clamp(static_cast<int>(at), 0, num_samples - 1);
    return nearest_period(surface_, raw_(s), samples_[i] + (at - i) * (samples_[i + 1] - samples_[i]));
  }

  /// The chart has the point of the boundary where the exact curve has it within its accuracy alone.
  Vec2 correction(const SurfaceNode& node, double s) const {
    const Vec2 here = continuous(s);
    Vec2 missing = nearest_period(surface_, node.uv, here) - here;
    if (node.free != Parameter::none) part(missing, node.free) = 0;
    return missing;
  }

  void extrapolate(Parameter free, double s, double pole, Vec2& uv) const {
    const double h = (pole > 0 ? -near_pole : near_pole) * length_;
    if (free == Parameter::none || std::abs(s - pole) >= std::abs(h)) return;
    const Vec2 near = (*this)(pole + h), far = (*this)(pole + 2 * h);
    part(uv, free) = part(near, free) + (part(near, free) - part(far, free)) * (1 - (s - pole) / h);
  }

  const NurbsSurface& surface_;
  Raw raw_;
  double length_;
  Parameter free_start_, free_end_;
  std::vector<Vec2> samples_;
  Vec2 at_start_, at_end_;
};

Nurbs scaled(Nurbs curve, double u, double v) {
  for (Vec2& pole : curve.poles) pole = {u * pole.x, v * pole.y};
  return curve;
}

/// `tolerance`: a length on the surface.
Nurbs fitted(const NurbsSurface& surface, const ParameterPath& path, double length, double tolerance) {
  double speed_u = 0, speed_v = 0;
  for (int i = 0; i <= num_samples; ++i) {
    const surface::SurfacePoint at = surface::evaluate(surface, path.sample(i));
    speed_u = std::max(speed_u, norm(at.xu)), speed_v = std::max(speed_v, norm(at.xv));
  }
  const auto in_lengths = [&](Vec2 uv) { return Vec2{speed_u * uv.x, speed_v * uv.y}; };
  const curve::CurveFunction function = [&](double s, Vec2& derivative) {
    if (s == 0 || s == length) derivative = in_lengths(path.slope(s > 0));
    return in_lengths(path(s));
  };
  return scaled(curve::fit_line(function, length, tolerance), 1 / speed_u, 1 / speed_v);
}

std::vector<double> breaks_of(const Nurbs& a, const Nurbs& b) {
  std::vector<double> breaks = a.knots;
  breaks.insert(breaks.end(), b.knots.begin(), b.knots.end());
  std::sort(breaks.begin(), breaks.end());
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
  return breaks;
}

/// The curve X(uv(s)) of the surface, as a cubic spline.
SpaceCurve curve_on(const NurbsSurface& surface, const Nurbs& uv, double tolerance) {
  const auto at = [&](double s, Vec3& derivative) {
    const auto [value, slope] = curve::point_and_derivative(uv, s);
    const surface::SurfacePoint x = surface::evaluate(surface, value);
    derivative = slope.x * x.xu + slope.y * x.xv;
    return x.x;
  };
  const auto image = [&](bool is_xz) {
    return [&at, is_xz](double s, Vec2& derivative) {
      Vec3 slope;
      const Vec3 x = at(s, slope);
      derivative = {slope.x, is_xz ? slope.z : slope.y};
      return Vec2{x.x, is_xz ? x.z : x.y};
    };
  };
  const double length = uv.end();
  const std::vector<double> breaks =
      breaks_of(curve::fit_line(image(false), length, tolerance), curve::fit_line(image(true), length, tolerance));
  const auto through = [&](bool is_xz) {
    std::vector<Vec2> points;
    Vec2 slope, start, end;
    for (const double s : breaks) {
      points.push_back(image(is_xz)(s, slope));
      if (s == 0) start = slope;
      end = slope;
    }
    return curve::cubic_spline(breaks, points, start, end);
  };
  return space::combined(through(false), through(true));
}

/// Greatest distance of the two curves at the same parameter.
double distance_of(const NurbsSurface& surface, const SpaceCurve& space, const Nurbs& uv) {
  constexpr int count = 200;
  double greatest = 0;
  for (int i = 0; i <= count; ++i) {
    const double s = uv.begin() + (uv.end() - uv.begin()) * i / count;
    greatest = std::max(greatest, distance(surface::point(space, s), surface::point(surface, curve::point(uv, s))));
  }
  return greatest;
}

/// The parameter, or a knot beside it: between both the curve would have a span without length.
double snapped(const SpaceCurve& curve, double t) {
  const double near = 1e-8 * (curve.end() - curve.begin());
  for (const double knot : curve.knots)
    if (std::abs(knot - t) < near) return knot;
  return t;
}

void shift_parameters(std::vector<double>& knots, double begin) {
  for (double& t : knots) t -= begin;
}

}  // namespace

double period(const NurbsSurface& surface, Parameter p) {
  if (p == Parameter::none || !is_closed(surface, p)) return 0;
  const std::vector<double>& knots = p == Parameter::u ? surface.knots_u : surface.knots_v;
  return knots.back() - knots.front();
}

Parameter undetermined(const NurbsSurface& surface, Vec2 uv, double diameter) {
  constexpr double no_length = 1e-8;  // diameters
  const surface::SurfacePoint at = surface::evaluate(surface, uv);
  if (norm(at.xu) * (surface.knots_u.back() - surface.knots_u.front()) < no_length * diameter) return Parameter::u;
  if (norm(at.xv) * (surface.knots_v.back() - surface.knots_v.front()) < no_length * diameter) return Parameter::v;
  return Parameter::none;
}

SurfacePieces::SurfacePieces(const BlockLayout& layout) : layout_(layout), map_(layout.face) {
  if (layout.face.chart->surfaces.size() != 1)
    throw ComputeError("blocks on several surfaces cannot be written as a STEP model");
}

SurfaceNode SurfacePieces::node(int curve, double t) const {
  const Vec2 x = curve::point(layout_.curve(curve), t);
  SurfaceNode node;
  node.position = curve < layout_.face.num_curves() ? map_.boundary_point(curve, t) : map_.lift(x);
  std::optional<Vec2> uv;
  map_.distance_from_surface(node.position, x, uv);
  node.uv = *uv, node.free = undetermined(surface(), *uv, layout_.face.diameter);
  return node;
}

SurfaceNode SurfacePieces::node(int n) const {
  const GraphNode& at = layout_.nodes[n];
  if (at.curve >= 0) return node(at.curve, at.t);
  SurfaceNode node;
  std::optional<Vec2> uv;
  node.position = map_.lift(at.position);
  map_.distance_from_surface(node.position, at.position, uv);
  node.uv = *uv, node.free = undetermined(surface(), *uv, layout_.face.diameter);
  return node;
}

SurfacePiece SurfacePieces::piece(const ArcPiece& of_arc, const SurfaceNode& start, const SurfaceNode& end) const {
  ArcPiece piece = of_arc;
  const bool is_exact = piece.curve < layout_.face.num_curves();
  if (is_exact)
    for (double* t : {&piece.t0, &piece.t1}) *t = snapped(layout_.face.chart->space_curves[piece.curve], *t);
  const double length = std::abs(piece.t1 - piece.t0), tolerance = (is_exact ? 1e-8 : 1e-6) * layout_.face.diameter;
  const Nurbs& in_chart = layout_.curve(piece.curve);
  const ParameterPath path(
      surface(),
      [&](double s) {
        const double t = piece.t0 < piece.t1 ? piece.t0 + s : piece.t0 - s;
        const Vec2 x = curve::point(in_chart, t);
        std::optional<Vec2> uv;
        map_.distance_from_surface(is_exact ? map_.boundary_point(piece.curve, t) : map_.lift(x), x, uv);
        return *uv;
      },
      length, start, end);
  SurfacePiece result;
  result.start = start, result.end = end;
  result.uv = fitted(surface(), path, length, tolerance);
  if (is_exact) {
    const auto [low, high] = std::minmax(piece.t0, piece.t1);
    result.space = space::trimmed(layout_.face.chart->space_curves[piece.curve], low, high);
    if (piece.t0 > piece.t1) result.space = surface::reversed(result.space);
    shift_parameters(result.space.knots, low);
  } else {
    result.space = curve_on(surface(), result.uv, 1e-8 * layout_.face.diameter);
  }
  result.distance = distance_of(surface(), result.space, result.uv);
  return result;
}

bool SurfacePieces::keeps_orientation() const {
  const Chart& chart = *layout_.face.chart;
  double sum = 0;
  for (std::size_t e = 0; e < chart.elem2vertices.size(); ++e) {
    const Vec3* const x = &chart.space_nodes[e * chart.nodes_per_elem()];
    const Vec3 normal = cross(x[1] - x[0], x[2] - x[0]);
    for (int k = 0; k < 3; ++k) {
      const surface::SurfacePoint at = surface::evaluate(surface(), chart.uv[e * chart.nodes_per_elem() + k]);
      sum += dot(normal, cross(at.xu, at.xv));
    }
  }
  return sum > 0;
}

}  // namespace quadrille::occ
