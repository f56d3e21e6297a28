#pragma once
// The motions in space of periodic sides of a curved face. They follow from the curves and the surface, so that no file
// has them.

#include <array>
#include <vector>

#include "model/cad_face.hpp"
#include "model/hex_mesh.hpp"

namespace quadrille::surface {

/// Where a rigid motion moves x, and what it moves to y.
Vec3 image(const SpaceMotion& motion, Vec3 x);
Vec3 original(const SpaceMotion& motion, Vec3 y);

/// Curves in space of a face with a chart that follow each other along its boundary: numbers, in its direction.
using CurvesInSpace = std::vector<int>;

/// The rigid motion that maps the ends of the first curves onto those of the second ones, reversed. It also maps the
/// vector area between the first curves and the line through their ends or, if they lie on it, the normal of the
/// surface at an end, as far as that is possible. An angle within 1e-9 of a whole fraction of a turn is that fraction.
SpaceMotion motion_between(const Chart& chart, const CurvesInSpace& first, const CurvesInSpace& second);

/// That of a periodic pair of a face with a chart: it maps the first curve onto the second, point by point of equal
/// parameters, reversed.
SpaceMotion periodic_motion(const CadFace& face, const PeriodicPair& pair);

/// The angle of a whole fraction of a turn, up to 1/720, that is within 1e-9 of `angle`, or `angle` itself.
double snapped_to_fraction(double angle);

/// A rotation about an axis through (0, 0, 0), by an angle, 0 to pi, and then a translation.
struct RotationAxis {
  Vec3 direction{0, 0, 1};  ///< of unit length; of no meaning where the angle is 0
  double angle = 0;
};
RotationAxis rotation_axis(const SpaceMotion& motion);
std::array<Vec3, 3> rotation_about(const RotationAxis& axis);

/// The rotation that maps one orthonormal frame, by columns, onto another.
std::array<Vec3, 3> rotation_between(const std::array<Vec3, 3>& from, const std::array<Vec3, 3>& to);

}  // namespace quadrille::surface
