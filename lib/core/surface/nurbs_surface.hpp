#pragma once
// Evaluation of NURBS curves in space and of NURBS surfaces, and nearest points (Piegl and Tiller, The NURBS Book, ch.
// 3 to 6). Parameters outside the domain are clamped to it, or brought back into it where the surface is closed.

#include <array>

#include "base/vec2.hpp"
#include "base/vec3.hpp"
#include "model/chart.hpp"

namespace quadrille::surface {

/// Point, first and second derivative with respect to t; at a knot from the right, or from the left if `from_left`.
std::array<Vec3, 3> derivatives(const SpaceCurve& curve, double t, bool from_left = false);
/// The ends are the first and the last pole, bit for bit.
Vec3 point(const SpaceCurve& curve, double t);
/// The same curve in the opposite direction, on the same parameter interval.
SpaceCurve reversed(const SpaceCurve& curve);

/// A point of a surface and its derivatives with respect to u and v.
struct SurfacePoint {
  Vec3 x, xu, xv, xuu, xuv, xvv;
};

/// At knots from the right.
SurfacePoint evaluate(const NurbsSurface& surface, Vec2 uv);
Vec3 point(const NurbsSurface& surface, Vec2 uv);
/// The greatest absolute curvature (1 / length) of normal sections; 0 where the parametrisation degenerates.
double greatest_curvature(const NurbsSurface& surface, Vec2 uv);
/// The parameters in the domain: clamped, or less whole periods where the surface is closed.
Vec2 in_domain(const NurbsSurface& surface, Vec2 uv);

struct SurfaceProjection {
  Vec2 uv;
  Vec3 position;
  double distance = 0;
  bool is_converged = false;  ///< false: no stationary point was found near the first guess
};

/// The point of the surface nearest to x near the first guess `uv`: Newton's method on the squared distance, damped
/// where the surface's parametrisation degenerates; at a pole, the first guess is moved beside it.
SurfaceProjection project(const NurbsSurface& surface, Vec3 x, Vec2 uv);

}  // namespace quadrille::surface
