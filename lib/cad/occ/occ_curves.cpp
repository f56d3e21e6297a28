#include "occ/occ_curves.hpp"

#include <GeomAdaptor_Curve.hxx>
#include <GeomConvert.hxx>
#include <GeomConvert_ApproxCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_Line.hxx>
#include <Geom_Parabola.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"
#include "curve/span.hpp"

namespace quadrille::occ {
namespace {

double dot(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

std::array<double, 3> relative(const gp_Pnt& p, const std::array<double, 3>& origin) {
  return {p.X() - origin[0], p.Y() - origin[1], p.Z() - origin[2]};
}

// C + cos(u) a + sin(u) b is the affine image of the unit circle, and so is its NURBS.
Nurbs conic(Vec2 centre, Vec2 a, Vec2 b, double first, double last) {
  if (!(last - first < 2 * pi * (1 + 1e-9))) throw FormatError("an arc goes round more than once");
  Nurbs arc = curve::circular_arc({0, 0}, 1, first, last);
  for (Vec2& pole : arc.poles) pole = centre + pole.x * a + pole.y * b;
  return arc;
}

double greatest_height(const Geom_Curve& curve, double first, double last, const PlaneFrame& frame) {
  double height = 0;
  for (int i = 0; i <= 16; ++i)
    height = std::max(height, std::abs(frame.height(curve.Value(first + (last - first) * i / 16))));
  return height;
}

// Copies the poles and flat knots unchanged: knots of a non-periodic spline need not be clamped.
Nurbs copied(const Geom_BSplineCurve& spline, const PlaneFrame& frame, double& height) {
  Nurbs curve;
  curve.degree = spline.Degree();
  for (int i = 1; i <= spline.NbKnots(); ++i)
    curve.knots.insert(curve.knots.end(), spline.Multiplicity(i), spline.Knot(i));
  for (int i = 1; i <= spline.NbPoles(); ++i) {
    curve.poles.push_back(frame.position(spline.Pole(i)));
    curve.weights.push_back(spline.Weight(i));
    height = std::max(height, std::abs(frame.height(spline.Pole(i))));
    if (!(spline.Weight(i) > 0)) throw FormatError("a B-spline curve has a weight that is not positive");
  }
  if (curve.degree > curve::max_curve_degree || curve.knots.size() != curve.poles.size() + curve.degree + 1)
    throw FormatError("a B-spline curve has a wrong number of knots");
  return curve;
}

// `head` followed by `tail`, which starts at the end of `head`, with one common parameter.
Nurbs joined(Nurbs head, const Nurbs& tail) {
  const double shift = head.end() - tail.begin(), scale = head.weights.back() / tail.weights.front();
  head.knots.pop_back();
  for (size_t i = tail.degree + 1; i < tail.knots.size(); ++i) head.knots.push_back(tail.knots[i] + shift);
  for (size_t i = 1; i < tail.poles.size(); ++i) {
    head.poles.push_back(tail.poles[i]);
    head.weights.push_back(tail.weights[i] * scale);
  }
  return head;
}

// The part [first, last] of a curve, or of a closed curve across its seam; ends within round-off of `low` or `high` are
// snapped to them.
Nurbs part(const Nurbs& whole, double low, double high, double first, double last, bool closed) {
  const double period = high - low, near = 1e-9 * period;
  if (closed) {
    const double shift = period * std::floor((first - low + near) / period);
    first -= shift, last -= shift;
  }
  const auto snapped = [&](double t) {
    return std::abs(t - low) <= near ? low : std::abs(t - high) <= near ? high : t;
  };
  first = snapped(first), last = snapped(last);
  if (!(std::max(first, low) < last) || (!closed && !(first < high)))
    throw FormatError("the ends of the edge lie off its B-spline curve");
  if (!closed || last <= high) return curve::trimmed(whole, std::max(first, low), std::min(last, high));
  return joined(curve::trimmed(whole, first, high), curve::trimmed(whole, low, snapped(last - period)));
}

PlaneCurve spline_part(const Handle(Geom_BSplineCurve) & spline, double first, double last, const PlaneFrame& frame) {
  PlaneCurve result;
  const bool closed = spline->IsPeriodic();
  const double low = spline->FirstParameter(), high = spline->LastParameter();
  Handle(Geom_BSplineCurve) open = spline;
  if (closed) {
    open = Handle(Geom_BSplineCurve)::DownCast(spline->Copy());
    open->SetNotPeriodic();
  }
  if (!(high > low) || !(last > first)) throw FormatError("a B-spline curve has an empty parameter interval");
  result.curve = part(copied(*open, frame, result.height), low, high, first, last, closed);
  return result;
}

PlaneCurve approximated(const Handle(Geom_Curve) & curve, double first, double last, const PlaneFrame& frame,
                        double tolerance) {
  const GeomConvert_ApproxCurve fit(new Geom_TrimmedCurve(curve, first, last), tolerance, GeomAbs_C2, 400, 9);
  if (!fit.HasResult())
    throw FormatError("a curve of type " + std::string(curve->DynamicType()->Name()) +
                      " cannot be converted to a B-spline");
  PlaneCurve result = spline_part(fit.Curve(), fit.Curve()->FirstParameter(), fit.Curve()->LastParameter(), frame);
  result.error = fit.MaxError();
  return result;
}

}  // namespace

Vec2 PlaneFrame::position(const gp_Pnt& p) const {
  const auto d = relative(p, origin);
  return {dot(d, e_x), dot(d, e_y)};
}

Vec2 PlaneFrame::direction(const gp_XYZ& d) const {
  const std::array<double, 3> v{d.X(), d.Y(), d.Z()};
  return {dot(v, e_x), dot(v, e_y)};
}

double PlaneFrame::height(const gp_Pnt& p) const {
  const std::array<double, 3> normal{e_x[1] * e_y[2] - e_x[2] * e_y[1], e_x[2] * e_y[0] - e_x[0] * e_y[2],
                                     e_x[0] * e_y[1] - e_x[1] * e_y[0]};
  return dot(relative(p, origin), normal);
}

PlaneCurve plane_curve(const Handle(Geom_Curve) & curve, double first, double last, const PlaneFrame& frame,
                       double tolerance) {
  if (const auto trim = Handle(Geom_TrimmedCurve)::DownCast(curve); !trim.IsNull())
    return plane_curve(trim->BasisCurve(), first, last, frame, tolerance);
  if (const auto spline = Handle(Geom_BSplineCurve)::DownCast(curve); !spline.IsNull())
    return spline_part(spline, first, last, frame);
  PlaneCurve result;
  result.height = greatest_height(*curve, first, last, frame);
  if (!curve->DynamicType()->SubType(STANDARD_TYPE(Geom_Line)) && !(last > first))
    throw FormatError("a curve has an empty parameter interval");
  if (curve->IsKind(STANDARD_TYPE(Geom_Line))) {
    result.curve = curve::segment(frame.position(curve->Value(first)), frame.position(curve->Value(last)));
  } else if (const auto circle = Handle(Geom_Circle)::DownCast(curve); !circle.IsNull()) {
    const gp_Ax2& axes = circle->Position();
    result.curve = conic(frame.position(axes.Location()), circle->Radius() * frame.direction(axes.XDirection().XYZ()),
                         circle->Radius() * frame.direction(axes.YDirection().XYZ()), first, last);
  } else if (const auto ellipse = Handle(Geom_Ellipse)::DownCast(curve); !ellipse.IsNull()) {
    const gp_Ax2& axes = ellipse->Position();
    result.curve =
        conic(frame.position(axes.Location()), ellipse->MajorRadius() * frame.direction(axes.XDirection().XYZ()),
              ellipse->MinorRadius() * frame.direction(axes.YDirection().XYZ()), first, last);
  } else if (curve->IsKind(STANDARD_TYPE(Geom_BezierCurve)) || curve->IsKind(STANDARD_TYPE(Geom_Parabola)) ||
             curve->IsKind(STANDARD_TYPE(Geom_Hyperbola))) {
    const auto spline = GeomConvert::CurveToBSplineCurve(new Geom_TrimmedCurve(curve, first, last));
    return spline_part(spline, spline->FirstParameter(), spline->LastParameter(), frame);
  } else {
    const double height = result.height;
    result = approximated(curve, first, last, frame, tolerance);
    result.height = std::max(result.height, height);
  }
  return result;
}

}  // namespace quadrille::occ
