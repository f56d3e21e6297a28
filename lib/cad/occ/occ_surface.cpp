#include "occ/occ_surface.hpp"

#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <GeomConvert_ApproxSurface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <algorithm>
#include <cmath>
#include <functional>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/tolerance.hpp"
#include "base/vec3.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::occ {

namespace {

Vec3 vector(const gp_XYZ& v) { return {v.X(), v.Y(), v.Z()}; }

Vec3 point_of(const Handle(Geom_Surface) & surface, Vec2 uv) { return vector(surface->Value(uv.x, uv.y).XYZ()); }

/// Not normalised; zero at a pole.
Vec3 normal_of(const Handle(Geom_Surface) & surface, Vec2 uv) {
  gp_Pnt p;
  gp_Vec u, v;
  surface->D1(uv.x, uv.y, p, u, v);
  return cross(vector(u.XYZ()), vector(v.XYZ()));
}

/// One direction of a surface: the interval of the face, and what the surface allows.
struct Extent {
  double begin = 0, end = 1;  ///< of the face
  double least = 0, most = 1;
  double period = 0;       ///< 0: none
  bool is_closed = false;  ///< the surface closes, and the face goes all the way round
};

/// `is_closed`, `is_periodic`: the surface in this direction.
Extent extent(double begin, double end, double least, double most, bool is_closed, bool is_periodic) {
  Extent e{begin, end, least, most, is_periodic ? most - least : 0, false};
  e.is_closed = is_closed && end - begin > (most - least) * (1 - tolerance::same_point);
  if (e.is_closed) e.begin = least, e.end = most;  // parameters of the face may be whole periods away
  return e;
}

constexpr double margin = 0.05;  // of the interval, on either side

/// The end of the interval, moved outwards by up to a margin: where the surface allows, and its normal does not turn
/// over, as it does beyond the apex of a cone.
double widened_end(const Handle(Geom_Surface) & surface, const Extent& e, bool is_end, const Vec2& middle, bool is_u) {
  double end = is_end ? e.end : e.begin;
  if (e.period == 0) end = std::clamp(end, e.least, e.most);  // a pole may lie beyond by round-off
  double step = margin * (e.end - e.begin) * (is_end ? 1 : -1);
  if (e.period > 0) {
    const double rest = (e.period - (e.end - e.begin)) / 3;
    step = std::clamp(step, -rest, rest);
  } else {
    step = std::clamp(end + step, e.least, e.most) - end;
  }
  const Vec3 inside = normal_of(surface, middle);
  for (int halvings = 0; halvings < 8; ++halvings, step /= 2) {
    const double t = end + step;
    const Vec2 at = is_u ? Vec2{t, middle.y} : Vec2{middle.x, t},
               near = is_u ? Vec2{end, middle.y} : Vec2{middle.x, end};
    const Vec3 outside = normal_of(surface, at), there = normal_of(surface, near);
    if (norm(there) < 1e-6 * norm(inside)) return end;
    if (dot(outside, there) > 0.1 * norm2(there)) return t;
  }
  return end;
}

Handle(Geom_BSplineSurface) approximated(const Handle(Geom_Surface) & surface, double tolerance) {
  const GeomConvert_ApproxSurface fit(surface, tolerance, GeomAbs_C2, GeomAbs_C2, 9, 9, 200, 0);
  if (!fit.HasResult())
    throw FormatError("a surface of type " + std::string(surface->DynamicType()->Name()) +
                      " cannot be converted to a B-spline");
  return fit.Surface();
}

/// The kernel trims the surface below an offset one first, and moves that part into its first period.
ParameterBox in_first_period(const Handle(Geom_OffsetSurface) & surface, ParameterBox box) {
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  surface->Bounds(u0, u1, v0, v1);
  const auto move = [](double& low, double& high, double first, double period) {
    const double shift = period * std::floor((low - first) / period);
    low -= shift, high -= shift;
  };
  if (surface->IsUPeriodic()) move(box.u0, box.u1, u0, u1 - u0);
  if (surface->IsVPeriodic()) move(box.v0, box.v1, v0, v1 - v0);
  return box;
}

Handle(Geom_BSplineSurface) spline_of(const Handle(Geom_Surface) & surface, ParameterBox box, double tolerance) {
  const auto offset = Handle(Geom_OffsetSurface)::DownCast(surface);
  if (!offset.IsNull()) box = in_first_period(offset, box);
  const Handle(Geom_Surface) part = new Geom_RectangularTrimmedSurface(surface, box.u0, box.u1, box.v0, box.v1);
  if (!offset.IsNull()) return approximated(part, tolerance);
  Handle(Geom_BSplineSurface) spline = GeomConvert::SurfaceToBSplineSurface(part);
  if (spline.IsNull()) spline = approximated(part, tolerance);
  if (spline->IsUPeriodic()) spline->SetUNotPeriodic();
  if (spline->IsVPeriodic()) spline->SetVNotPeriodic();
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  spline->Bounds(u0, u1, v0, v1);
  spline->Segment(u0, u1, v0, v1);  // which clamps the knots: those of a surface that was periodic are not
  return spline;
}

/// Flat knots; the trim of a periodic surface may have moved them by whole periods.
std::vector<double> flat_knots(int number, const std::function<double(int)>& knot,
                               const std::function<int(int)>& multiplicity, double begin, double period) {
  const double shift = period > 0 ? period * std::round((begin - knot(1)) / period) : 0;
  std::vector<double> knots;
  for (int i = 1; i <= number; ++i) knots.insert(knots.end(), multiplicity(i), knot(i) + shift);
  return knots;
}

NurbsSurface copied(const Handle(Geom_BSplineSurface) & s, const Extent& u, const Extent& v, const ParameterBox& box) {
  NurbsSurface result;
  result.degree_u = s->UDegree(), result.degree_v = s->VDegree();
  result.knots_u = flat_knots(
      s->NbUKnots(), [&](int i) { return s->UKnot(i); }, [&](int i) { return s->UMultiplicity(i); }, box.u0, u.period);
  result.knots_v = flat_knots(
      s->NbVKnots(), [&](int i) { return s->VKnot(i); }, [&](int i) { return s->VMultiplicity(i); }, box.v0, v.period);
  result.is_closed_u = u.is_closed, result.is_closed_v = v.is_closed;
  for (int i = 1; i <= s->NbUPoles(); ++i)
    for (int j = 1; j <= s->NbVPoles(); ++j) {
      result.poles.push_back(vector(s->Pole(i, j).XYZ()));
      // The kernel has weights of rational splines only.
      result.weights.push_back(s->IsURational() || s->IsVRational() ? s->Weight(i, j) : 1);
      if (!(result.weights.back() > 0)) throw FormatError("the surface has a weight that is not positive");
    }
  return result;
}

}  // namespace

Handle(Geom_Surface) basis_surface(const TopoDS_Face& face) {
  Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  for (;;) {
    if (const auto trim = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface); !trim.IsNull()) {
      surface = trim->BasisSurface();
    } else if (const auto offset = Handle(Geom_OffsetSurface)::DownCast(surface);
               !offset.IsNull() && !offset->Surface().IsNull()) {
      surface = offset->Surface();  // that of a cylinder is a cylinder
    } else {
      return surface;
    }
  }
}

ConvertedSurface::ConvertedSurface(Handle(Geom_Surface) surface, const ParameterBox& box, double tolerance)
    : surface_(std::move(surface)), box_(box) {
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  surface_->Bounds(u0, u1, v0, v1);
  const Extent u = extent(box.u0, box.u1, u0, u1, surface_->IsUClosed(), surface_->IsUPeriodic());
  const Extent v = extent(box.v0, box.v1, v0, v1, surface_->IsVClosed(), surface_->IsVPeriodic());
  const Vec2 middle{(box.u0 + box.u1) / 2, (box.v0 + box.v1) / 2};
  const auto low = [&](const Extent& e, bool is_u) {
    return e.is_closed ? e.begin : widened_end(surface_, e, false, middle, is_u);
  };
  const auto high = [&](const Extent& e, bool is_u) {
    return e.is_closed ? e.end : widened_end(surface_, e, true, middle, is_u);
  };
  const ParameterBox wide{low(u, true), high(u, true), low(v, false), high(v, false)};
  spline_ = copied(spline_of(surface_, wide, tolerance), u, v, wide);
  const auto same = [&](Vec2 uv) { return distance(surface::point(spline_, uv), point_of(surface_, uv)); };
  const double size = 1e-9 * distance(point_of(surface_, {box.u0, box.v0}), point_of(surface_, middle));
  is_same_u_ = is_same_v_ = true;
  for (const double f : {0.13, 0.29, 0.57, 0.83}) {
    const Vec2 at{box.u0 + f * (box.u1 - box.u0), box.v0 + f * (box.v1 - box.v0)};
    if (same(at) > size) is_same_u_ = is_same_v_ = false;
  }
}

double ConvertedSurface::mapped(double t, bool is_u) const {
  const std::vector<double>& knots = is_u ? spline_.knots_u : spline_.knots_v;
  const bool is_closed = is_u ? spline_.is_closed_u : spline_.is_closed_v;
  const double begin = knots.front(), end = knots.back();
  const double shift = is_closed ? (end - begin) * std::floor((t - begin) / (end - begin)) : 0;
  const double near = 1e-12 * (end - begin), base = t - shift;
  if (base <= begin + near) return begin + shift;
  if (base >= end - near) return end + shift;
  const Vec2 middle{(box_.u0 + box_.u1) / 2, (box_.v0 + box_.v1) / 2};
  const Vec2 at = is_u ? Vec2{t, middle.y} : Vec2{middle.x, t},
             guess = is_u ? Vec2{base, middle.y} : Vec2{middle.x, base};
  const Vec2 found = surface::project(spline_, point_of(surface_, at), guess).uv;
  return (is_u ? found.x : found.y) + shift;
}

Vec2 ConvertedSurface::spline_parameters(Vec2 uv) const {
  return {is_same_u_ ? uv.x : mapped(uv.x, true), is_same_v_ ? uv.y : mapped(uv.y, false)};
}

double ConvertedSurface::deviation(Vec2 uv) const {
  return distance(surface::point(spline_, spline_parameters(uv)), point_of(surface_, uv));
}

}  // namespace quadrille::occ
