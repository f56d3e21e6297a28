#pragma once
// Neighbouring regions of one name as one region.

#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::cad {

/// Removes the curves between regions of `named` that have one name: regions that such curves connect are one region,
/// in the place of the first of them. Curves, loops and unnamed curves are numbered anew; if one region is left, it is
/// the face, with its name. `corner_angle`, radians: a greater tangent jump is a corner. Throws FormatError, with the
/// name and the place, for a region that would touch itself in a point.
void merge_regions(CadFace& face, const std::vector<int>& named, double corner_angle);

}  // namespace quadrille::cad
