#pragma once
// The curve at a distance to the left of another one: p(s) + d(s) n(s), n the unit normal.

#include <string>

#include "model/cad_face.hpp"
#include "offset/offset_profile.hpp"

namespace quadrille::offset {

/// With a constant distance a line or an arc has a line or an arc, exactly; otherwise a spline fitted within
/// `tolerance`, a length. Throws ComputeError, beginning with `where`, if a bend is too narrow: the offset curve would
/// turn back there. `origin`: added to positions in messages.
Nurbs offset_curve(const Nurbs& curve, const OffsetProfile& profile, double tolerance, const std::string& where,
                   Vec2 origin);

}  // namespace quadrille::offset
