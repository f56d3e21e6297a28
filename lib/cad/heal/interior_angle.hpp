#pragma once
// The interior angle of a face between two consecutive curves of its boundary, and cusps, where it is zero.

#include "model/cad_face.hpp"

namespace quadrille::heal {

/// The angle between `in`, which ends where `out` starts, with the face on their left: 0 to 2 pi. If the tangents are
/// opposite, points of the curves near the joint decide between 0 and 2 pi.
double interior_angle(const Nurbs& in, const Nurbs& out);

/// Whether an interior angle is zero, up to rounding: the joint is a cusp, which holds no quad.
bool is_cusp(double interior_angle);

}  // namespace quadrille::heal
