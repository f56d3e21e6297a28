#include "cad/split_curve.hpp"

#include <algorithm>
#include <utility>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::cad {
namespace {

// From its own start on.
Nurbs from_zero(Nurbs curve) {
  const double begin = curve.begin();
  for (double& knot : curve.knots) knot -= begin;
  return curve;
}

}  // namespace

void split_curve(CadFace& face, int curve, double t) {
  const Nurbs whole = face.curves[curve];
  const int added = curve + 1;
  const double tangent = angle_of(curve::tangent(whole, t));
  const auto renumber = [added](int& c) { c += c >= added; };
  face.curves[curve] = curve::trimmed(whole, whole.begin(), t);
  Nurbs rest = from_zero(curve::trimmed(whole, t, whole.end()));
  rest.poles.front() = face.curves[curve].poles.back();
  face.joints.insert(face.joints.begin() + added, {rest.poles.front(), tangent, tangent, pi, false});
  face.curves.insert(face.curves.begin() + added, std::move(rest));
  face.curve_names.insert(face.curve_names.begin() + added, std::string(face.curve_names[curve]));
  face.curve_cad_edges.insert(face.curve_cad_edges.begin() + added, int(face.curve_cad_edges[curve]));
  const bool is_unnamed = !face.has_given_name(curve);
  for (int& c : face.unnamed_curves) renumber(c);
  if (is_unnamed)
    face.unnamed_curves.insert(std::upper_bound(face.unnamed_curves.begin(), face.unnamed_curves.end(), curve), added);
  for (int& offset : face.loop_offsets) offset += offset > curve;
  if (!face.partners.empty()) {
    for (int& partner : face.partners) renumber(partner);
    face.partners.insert(face.partners.begin() + added, -1);
  }
  for (PeriodicPair& pair : face.periodic_pairs)
    for (int& c : pair.curves) renumber(c);
}

}  // namespace quadrille::cad
