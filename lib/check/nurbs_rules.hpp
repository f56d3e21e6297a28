#pragma once
// What makes a NURBS curve sound, and its point at a parameter, for the rules of several formats. Private to check.

#include <string>

#include "model/cad_face.hpp"

namespace quadrille::check {

/// Empty, or why the arrays of the curve do not fit together (formats/cad-face.md: clamped, never periodic).
std::string structure_fault(const Nurbs& curve);
/// Empty, or "pole 3 is not finite" and the like.
std::string number_fault(const Nurbs& curve);
/// Whether a pole lies so far outside (1000 diameters from the face's first joint) that arithmetic on the curve loses
/// its digits.
bool has_far_pole(const Nurbs& curve, const CadFace& face);
/// The point at t by de Boor's algorithm; the curve must be sound.
Vec2 curve_point(const Nurbs& curve, double t);

}  // namespace quadrille::check
