#pragma once
// Validity of a NURBS curve and its point at a parameter, for the rules of several formats. Private to check.

#include <string>

#include "model/cad_face.hpp"

namespace quadrille::check {

/// Empty if the arrays of the curve are consistent, else what is wrong (formats/cad-face.md: clamped, never periodic).
std::string structure_fault(const Nurbs& curve);
/// Empty if all numbers of the curve are finite, else a message such as "pole 3 is not finite".
std::string number_fault(const Nurbs& curve);
/// Whether a pole lies so far outside (1000 diameters from the face's first joint) that arithmetic on the curve loses
/// its digits.
bool has_far_pole(const Nurbs& curve, const CadFace& face);
/// The point at t by de Boor's algorithm; the curve must have passed the checks above.
Vec2 curve_point(const Nurbs& curve, double t);

}  // namespace quadrille::check
