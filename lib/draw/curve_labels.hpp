#pragma once
// Numbers and names of the boundary curves, written beside them: what cad2tri --name and --boundary-names refer to.

#include "draw/picture.hpp"

namespace quadrille::draw {

/// Writes "4 hole" (without the name where it is made from the number) beside each curve, outside the face where there
/// is room, else inside or farther away with a line to the curve; draws a dot on each joint that is not a corner.
/// Labels do not overlap each other, the boundary or the lines. A label without room is reduced to its number, then
/// omitted. Returns the number of omitted labels.
int label_curves(Picture& picture, const CadFace& face);

}  // namespace quadrille::draw
