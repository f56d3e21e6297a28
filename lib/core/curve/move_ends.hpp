#pragma once
// A curve with other ends, a little away from its own.

#include "model/cad_face.hpp"

namespace quadrille::curve {

/// The curve from `start` to `end`, bit for bit. Each pole moves by the displacements of the two ends, interpolated
/// linearly in the length of the control polygon up to it: poles that coincide remain so, and no leg of the polygon
/// turns by more than about the displacements over the polygon's length. A segment remains one.
Nurbs with_ends(Nurbs curve, Vec2 start, Vec2 end);

}  // namespace quadrille::curve
