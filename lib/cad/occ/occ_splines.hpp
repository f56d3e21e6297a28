#pragma once
// Our splines as those of OpenCASCADE.

#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <gp_Pnt.hxx>

#include "model/cad_face.hpp"

namespace quadrille::occ {

inline gp_Pnt occ_point(Vec3 x) { return {x.x, x.y, x.z}; }

Handle(Geom_BSplineCurve) occ_spline(const SpaceCurve& curve);
/// The curve, moved by `shift`.
Handle(Geom2d_BSplineCurve) occ_spline(const Nurbs& curve, Vec2 shift);
Handle(Geom_BSplineSurface) occ_spline(const NurbsSurface& surface);

/// The part of the surface with these parameters; where the surface closes, `high` may be up to a period beyond its
/// end, and the seam is no border of the part.
Handle(Geom_BSplineSurface) occ_part(const NurbsSurface& surface, Vec2 low, Vec2 high);

}  // namespace quadrille::occ
