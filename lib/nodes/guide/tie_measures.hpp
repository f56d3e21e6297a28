#pragma once
// The figures by which choices of valences at ties are compared.

#include "base/angle.hpp"
#include "model/cad_face.hpp"

namespace quadrille::guide {

/// What a corner of `valence` blocks adds to the angle defect: V (omega / (90 degrees V) - 1)^2. `angle`: omega,
/// radians.
inline double angle_defect(double angle, int valence) {
  const double off = angle / valence / half_pi - 1;
  return valence * off * off;
}

/// The distance between the ends of a boundary curve, a length.
inline double side_length(const CadFace& face, int curve) {
  return distance(face.joints[curve].position, face.joints[face.next_in_loop(curve)].position);
}

}  // namespace quadrille::guide
