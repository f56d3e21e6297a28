#pragma once
// Converts an OpenCASCADE curve in space to a NURBS in the plane of the face. Lines, conics and splines are exact.

#include <Geom_Curve.hxx>
#include <gp_Pnt.hxx>
#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::occ {

/// The plane of the face: x3d = origin + x e_x + y e_y (model/cad_face.hpp).
struct PlaneFrame {
  std::array<double, 3> origin{0, 0, 0}, e_x{1, 0, 0}, e_y{0, 1, 0};

  Vec2 position(const gp_Pnt& p) const;
  Vec2 direction(const gp_XYZ& d) const;
  /// Signed distance from the plane.
  double height(const gp_Pnt& p) const;
};

struct PlaneCurve {
  Nurbs curve;
  double height = 0;  ///< greatest distance of a pole or sample from the plane
  double error = 0;   ///< bound of the approximation error, a length; 0 if exact
};

/// The part of `curve` from parameter `first` to `last` (possibly beyond the end of the period of a periodic curve). A
/// curve type without exact rational form is approximated to `tolerance`, a length. Throws FormatError for a curve that
/// cannot be used.
PlaneCurve plane_curve(const Handle(Geom_Curve) & curve, double first, double last, const PlaneFrame& frame,
                       double tolerance);

}  // namespace quadrille::occ
