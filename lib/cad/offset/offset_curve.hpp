#pragma once
// The curve at a distance to the left of another one: p(s) + d(s) n(s), n the unit normal.

#include <string>

#include "model/cad_face.hpp"
#include "offset/chart_heights.hpp"
#include "offset/offset_profile.hpp"

namespace quadrille::offset {

/// With a constant distance in the plane a line or an arc has a line or an arc, exactly; otherwise a spline fitted
/// within `tolerance`, a length. On a curved face the distance is that in space. Throws ComputeError, beginning with
/// `where`, if a bend of the curve, of `face`, is too narrow: the offset curve would turn back there.
Nurbs offset_curve(const CadFace& face, const Nurbs& curve, const OffsetProfile& profile, const ChartHeights& heights,
                   double tolerance, const std::string& where);

}  // namespace quadrille::offset
