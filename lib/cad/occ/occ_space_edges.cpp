#include "occ/occ_space_edges.hpp"

#include <BRepLib.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Line.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopLoc_Location.hxx>
#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/vec3.hpp"
#include "occ/occ_curves.hpp"
#include "space/space_curve.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::occ {

namespace {

/// As it is stored, so that it has one address for all of its uses.
const Geom_Curve* stored_curve(const TopoDS_Edge& edge, double& first, double& last) {
  TopLoc_Location location;
  return BRep_Tool::Curve(edge, location, first, last).get();
}

}  // namespace

heal::RawEdge labels_of(const OccModel& model, const TopoDS_Edge& edge, int number) {
  const ShapeLabel label = model.label_of(edge);
  heal::RawEdge result;
  result.cad_edge = number;
  result.name = label.name, result.layer = label.layer, result.colour = label.colour;
  return result;
}

void require_curve(const TopoDS_Edge& edge) {
  double first = 0, last = 0;
  if (stored_curve(edge, first, last) == nullptr) BRepLib::BuildCurve3d(edge);
}

int FaceEdges::number_of(const TopoDS_Edge& edge) const {
  for (int i = 0; i < size(); ++i)
    if (edges_[i].IsSame(edge)) return i;
  double begin = 0, end = 0;
  const Geom_Curve* const curve = stored_curve(edge, begin, end);
  if (curve == nullptr) return -1;
  const double middle = (begin + end) / 2, period = curve->IsPeriodic() ? curve->Period() : 0;
  for (int i = 0; i < size(); ++i) {
    double first = 0, last = 0;
    if (stored_curve(edges_[i], first, last) != curve) continue;
    const double t = period > 0 ? middle - period * std::floor((middle - first) / period) : middle;
    if (t >= first && t <= last) return i;
  }
  return -1;
}

ConvertedCurve::ConvertedCurve(const TopoDS_Edge& edge, double first, double last, double tolerance)
    : first_(first), last_(last) {
  double begin = 0, end = 0;
  exact_ = BRep_Tool::Curve(edge, begin, end);
  if (exact_.IsNull()) throw FormatError("it has no curve");
  Handle(Geom_Curve) basis = exact_;
  while (basis->IsKind(STANDARD_TYPE(Geom_TrimmedCurve)))
    basis = Handle(Geom_TrimmedCurve)::DownCast(basis)->BasisCurve();
  if (basis->IsKind(STANDARD_TYPE(Geom_Line))) {
    const gp_Pnt a = basis->Value(first), b = basis->Value(last);
    curve_ = {1, {0, 0, a.Distance(b), a.Distance(b)}, {{a.X(), a.Y(), a.Z()}, {b.X(), b.Y(), b.Z()}}, {1, 1}};
    return;
  }
  PlaneFrame xz;
  xz.e_y = {0, 0, 1};
  const PlaneCurve image = plane_curve(basis, first, last, PlaneFrame(), tolerance);
  curve_ = space::combined(image.curve, plane_curve(basis, first, last, xz, tolerance).curve);
  error_ = image.error;
}

// Arcs are rational splines, with other parameters than the kernel's between their knots: the nearest point, by
// Newton's method.
double ConvertedCurve::parameter(double t) const {
  if (t <= first_) return curve_.begin();
  if (t >= last_) return curve_.end();
  const gp_Pnt p = exact_->Value(t);
  const Vec3 x{p.X(), p.Y(), p.Z()};
  const double range = curve_.end() - curve_.begin();
  double s = curve_.begin() + range * (t - first_) / (last_ - first_);
  for (int step = 0; step < 20; ++step) {
    const auto d = surface::derivatives(curve_, s);
    const Vec3 off = d[0] - x;
    const double slope = norm2(d[1]) + std::max(0.0, dot(off, d[2]));
    if (!(slope > 0)) break;
    const double ds = dot(off, d[1]) / slope;
    s = std::clamp(s - ds, curve_.begin(), curve_.end());
    if (std::abs(ds) <= 1e-15 * range) break;
  }
  return s;
}

}  // namespace quadrille::occ
