#pragma once
// Converts the surface of an OpenCASCADE face to a rational B-spline. Planes, cylinders, cones, spheres, tori, surfaces
// of revolution and extrusion, and splines are exact.

#include <Geom_Surface.hxx>
#include <TopoDS_Face.hxx>

#include "model/chart.hpp"

namespace quadrille::occ {

/// The part of a parameter plane in which a face lies.
struct ParameterBox {
  double u0 = 0, u1 = 1, v0 = 0, v1 = 1;
};

/// A surface of the kernel as a B-spline, whose parameters differ where arcs are rational splines: each of them by
/// itself, u_spline = f(u), v_spline = g(v).
class ConvertedSurface {
 public:
  /// `box`: of the face. The spline is a little larger, or the whole surface in a direction in which that closes and
  /// the face goes all the way round. `tolerance`: of surfaces without an exact form, a length. Throws FormatError if
  /// the kernel cannot convert the surface.
  ConvertedSurface(Handle(Geom_Surface) surface, const ParameterBox& box, double tolerance);

  const NurbsSurface& spline() const { return spline_; }
  /// The parameters on the spline of parameters of the kernel.
  Vec2 spline_parameters(Vec2 uv) const;
  /// Distance of the two surfaces at parameters of the kernel.
  double deviation(Vec2 uv) const;

 private:
  double mapped(double t, bool is_u) const;

  Handle(Geom_Surface) surface_;
  NurbsSurface spline_;
  ParameterBox box_;
  bool is_same_u_ = false, is_same_v_ = false;  ///< f, g are the identity
};

/// The surface of the face at its place, without trims. Null if it has none.
Handle(Geom_Surface) basis_surface(const TopoDS_Face& face);

}  // namespace quadrille::occ
