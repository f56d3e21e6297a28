#include "offset/offset_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "curve/chain.hpp"
#include "curve/nurbs.hpp"
#include "curve/pole_box.hpp"
#include "curve/simplify_spline.hpp"
#include "offset/wall_chains.hpp"
#include "surface/positions.hpp"

namespace quadrille::offset {

namespace {

/// The same weights and knots with poles at the distance: those of an arc are those of the arc of the other radius.
Nurbs scaled_arc(Nurbs curve, Vec2 centre, double factor) {
  for (Vec2& pole : curve.poles) pole = centre + factor * (pole - centre);
  return curve;
}

class OffsetPoints {
 public:
  OffsetPoints(const Nurbs& curve, const OffsetProfile& profile, const ChartHeights& heights)
      : curve_(curve), profile_(profile), heights_(heights), length_(curve) {}

  double total() const { return length_.total(); }

  Vec2 point(double s) const {
    const WallFoot at = foot(s);
    return at.position + heights_.in_chart(at, profile_.at(s)) * at.normal;
  }

  /// By the arc length of the wall.
  Vec2 derivative(double s) const {
    const WallFoot at = foot(s);
    const double height = heights_.in_chart(at, profile_.at(s)), bend = curvature(s);
    return (1 - height * bend) * -left_of(at.normal) +
           heights_.slope_in_chart(at, bend, height, profile_.slope(s)) * at.normal;
  }

  /// Length of the offset curve over that of the wall.
  double stretch(double s) const { return 1 - heights_.in_chart(foot(s), profile_.at(s)) * curvature(s); }

 private:
  bool is_end(double s) const { return s >= total(); }
  WallFoot foot(double s) const {
    const double t = length_.parameter(s);
    return {curve::point(curve_, t), left_of(curve::tangent(curve_, t, is_end(s)))};
  }
  double curvature(double s) const { return curve::curvature(curve_, length_.parameter(s), is_end(s)); }

  const Nurbs& curve_;
  const OffsetProfile& profile_;
  const ChartHeights& heights_;
  curve::ArcLength length_;
};

Nurbs through(const OffsetPoints& points, int count) {
  std::vector<double> lengths;
  std::vector<Vec2> positions;
  for (int i = 0; i <= count; ++i) {
    lengths.push_back(points.total() * i / count);
    positions.push_back(points.point(lengths.back()));
  }
  return curve::cubic_spline(lengths, positions, points.derivative(0), points.derivative(points.total()));
}

double greatest_deviation(const Nurbs& spline, const OffsetPoints& points, int count) {
  double greatest = 0;
  for (int i = 0; i < count; ++i) {
    const double s = points.total() * (i + 0.5) / count;
    greatest = std::max(greatest, distance(curve::point(spline, s), points.point(s)));
  }
  return greatest;
}

void require_no_fold(const CadFace& face, const Nurbs& curve, const OffsetPoints& points, const std::string& where) {
  const int count = offset_constants.first_fit_intervals;
  for (int i = 0; i <= count; ++i) {
    const double s = points.total() * i / count;
    if (points.stretch(s) > 0) continue;
    const Vec2 x = curve::point(curve, curve::ArcLength(curve).parameter(s));
    throw ComputeError(fmt::format("{}: the wall bends at {} with a smaller radius than the distance: use less", where,
                                   surface::position_text(face, x)));
  }
}

Nurbs fitted(const Nurbs& curve, const OffsetPoints& points, double tolerance) {
  int count = offset_constants.first_fit_intervals;
  Nurbs spline = through(points, count);
  while (count < offset_constants.most_fit_intervals && greatest_deviation(spline, points, count) > tolerance / 2)
    spline = through(points, count *= 2);
  if (curve::has_smooth_seam(curve)) spline.poles.back() = spline.poles.front();
  if (auto simple = curve::simplified_spline(spline, tolerance / 2)) return std::move(simple->curve);
  return spline;
}

}  // namespace

Nurbs offset_curve(const CadFace& face, const Nurbs& curve, const OffsetProfile& profile, const ChartHeights& heights,
                   double tolerance, const std::string& where) {
  const OffsetPoints points(curve, profile, heights);
  require_no_fold(face, curve, points, where);
  const curve::Carrier carrier = curve::carrier_of(curve);
  if (!profile.is_constant || !heights.is_planar() || carrier.kind == curve::CurveKind::spline)
    return fitted(curve, points, tolerance);
  if (carrier.kind == curve::CurveKind::line) {
    const Vec2 shift = profile.distance * left_of(carrier.direction);
    return curve::segment(curve.poles.front() + shift, curve.poles.back() + shift);
  }
  return scaled_arc(curve, carrier.point, points.stretch(0));
}

}  // namespace quadrille::offset
