#pragma once
// Tips of the surface of a curved face, as that of a cone: points without a tangent plane. A polynomial has one, so
// that an element there deviates from the surface by a part of its length, of whatever order it is.

#include <vector>

#include "base/vec3.hpp"
#include "model/chart.hpp"

namespace quadrille::refine {

/// In space: vertices of the chart's triangles where the parameters of the surface degenerate and its normals all
/// around are not those of one plane. A pole of a sphere is none.
std::vector<Vec3> surface_tips(const Chart& chart);

}  // namespace quadrille::refine
