#pragma once
// Two consecutive curves as one.

#include "model/cad_face.hpp"

namespace quadrille::sew {

/// The curve along `a` and then along `b`, which starts where `a` ends and has the same degree; exact, with an inner
/// knot of multiplicity `degree` between both. The parameters of `a` stay.
Nurbs joined_curve(const Nurbs& a, const Nurbs& b);

}  // namespace quadrille::sew
