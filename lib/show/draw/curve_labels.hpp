#pragma once
// Numbers and names of the boundary curves, written beside them: what cad2tri --name and --boundary-names refer to.

#include "draw/picture.hpp"

namespace quadrille::draw {

/// Call it after all other texts. CurveLabels::given writes each given name beside the longest of successive curves
/// that have it; CurveLabels::all writes "4 hole" (without the name where it is made from the number) beside each
/// curve and draws a dot on each joint that is not a corner. Labels lie outside the face where there is room, else
/// inside or farther away with a line to the curve. They do not overlap each other, other texts, the boundary or the
/// lines. The curves of an interface have one label, "1/7 name" with both numbers, and regions have their names in
/// them. A label without room is reduced to its number, if it has one, then omitted; the legend states how many are.
void label_curves(Picture& picture, const CadFace& face, CurveLabels which);

}  // namespace quadrille::draw
