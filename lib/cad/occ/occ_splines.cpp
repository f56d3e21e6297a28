#include "occ/occ_splines.hpp"

#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <algorithm>
#include <cstddef>
#include <vector>

namespace quadrille::occ {
namespace {

/// Different knots with their multiplicities.
struct Knots {
  TColStd_Array1OfReal values;
  TColStd_Array1OfInteger multiplicities;

  explicit Knots(const std::vector<double>& knots) : Knots(knots, different(knots)) {}

 private:
  static std::vector<double> different(std::vector<double> knots) {
    knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
    return knots;
  }
  Knots(const std::vector<double>& knots, const std::vector<double>& different)
      : values(1, static_cast<int>(different.size())), multiplicities(1, static_cast<int>(different.size())) {
    for (int i = 0; i < static_cast<int>(different.size()); ++i) {
      values.SetValue(i + 1, different[i]);
      multiplicities.SetValue(i + 1, static_cast<int>(std::count(knots.begin(), knots.end(), different[i])));
    }
  }
};

TColStd_Array1OfReal weights_of(const std::vector<double>& weights) {
  TColStd_Array1OfReal all(1, static_cast<int>(weights.size()));
  for (int i = 0; i < static_cast<int>(weights.size()); ++i) all.SetValue(i + 1, weights[i]);
  return all;
}

}  // namespace

Handle(Geom_BSplineCurve) occ_spline(const SpaceCurve& curve) {
  TColgp_Array1OfPnt poles(1, static_cast<int>(curve.poles.size()));
  for (int i = 0; i < poles.Length(); ++i) poles.SetValue(i + 1, occ_point(curve.poles[i]));
  const Knots knots(curve.knots);
  return new Geom_BSplineCurve(poles, weights_of(curve.weights), knots.values, knots.multiplicities, curve.degree);
}

Handle(Geom2d_BSplineCurve) occ_spline(const Nurbs& curve, Vec2 shift) {
  TColgp_Array1OfPnt2d poles(1, static_cast<int>(curve.poles.size()));
  for (int i = 0; i < poles.Length(); ++i)
    poles.SetValue(i + 1, {curve.poles[i].x + shift.x, curve.poles[i].y + shift.y});
  const Knots knots(curve.knots);
  return new Geom2d_BSplineCurve(poles, weights_of(curve.weights), knots.values, knots.multiplicities, curve.degree);
}

Handle(Geom_BSplineSurface) occ_spline(const NurbsSurface& surface) {
  const int nu = surface.num_poles_u(), nv = surface.num_poles_v();
  TColgp_Array2OfPnt poles(1, nu, 1, nv);
  TColStd_Array2OfReal weights(1, nu, 1, nv);
  for (int i = 0; i < nu; ++i)
    for (int j = 0; j < nv; ++j) {
      poles.SetValue(i + 1, j + 1, occ_point(surface.poles[i * nv + j]));
      weights.SetValue(i + 1, j + 1, surface.weights[i * nv + j]);
    }
  const Knots u(surface.knots_u), v(surface.knots_v);
  return new Geom_BSplineSurface(poles, weights, u.values, v.values, u.multiplicities, v.multiplicities,
                                 surface.degree_u, surface.degree_v);
}

namespace {

/// u in place of v.
NurbsSurface transposed(const NurbsSurface& s) {
  NurbsSurface result;
  result.degree_u = s.degree_v, result.degree_v = s.degree_u;
  result.knots_u = s.knots_v, result.knots_v = s.knots_u;
  result.is_closed_u = s.is_closed_v, result.is_closed_v = s.is_closed_u;
  for (int j = 0; j < s.num_poles_v(); ++j)
    for (int i = 0; i < s.num_poles_u(); ++i) {
      result.poles.push_back(s.poles[i * s.num_poles_v() + j]);
      result.weights.push_back(s.weights[i * s.num_poles_v() + j]);
    }
  return result;
}

/// Two turns about a surface that closes in u. Both have the row of poles in which they meet.
NurbsSurface two_turns(const NurbsSurface& s) {
  const double period = s.knots_u.back() - s.knots_u.front();
  const auto row = static_cast<std::ptrdiff_t>(s.num_poles_v());
  const double ratio = s.weights[s.weights.size() - static_cast<std::size_t>(row)] / s.weights.front();
  NurbsSurface result = s;
  result.knots_u.pop_back();
  for (std::size_t i = static_cast<std::size_t>(s.degree_u) + 1; i < s.knots_u.size(); ++i)
    result.knots_u.push_back(s.knots_u[i] + period);
  result.poles.insert(result.poles.end(), s.poles.begin() + row, s.poles.end());
  for (auto weight = s.weights.begin() + row; weight != s.weights.end(); ++weight)
    result.weights.push_back(ratio * *weight);
  return result;
}

}  // namespace

Handle(Geom_BSplineSurface) occ_part(const NurbsSurface& surface, Vec2 low, Vec2 high) {
  NurbsSurface turns = surface;
  if (surface.is_closed_u) turns = two_turns(turns);
  if (surface.is_closed_v) turns = transposed(two_turns(transposed(turns)));
  Handle(Geom_BSplineSurface) part = occ_spline(turns);
  part->Segment(low.x, high.x, low.y, high.y);
  return part;
}

}  // namespace quadrille::occ
