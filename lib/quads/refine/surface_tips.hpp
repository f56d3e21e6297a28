#pragma once
// Tips of the surface of a curved face, as that of a cone: points without a tangent plane. A polynomial has one, so
// that an element there deviates from the surface by a part of its length, of whatever order it is.

#include <vector>

#include "base/vec3.hpp"
#include "model/chart.hpp"

namespace quadrille::refine {

/// Positions in space of the tips: vertices of the chart's triangles at which the surface's parametrisation degenerates
/// and its normals differ around the vertex. The pole of a sphere, where the normals agree, is not a tip.
std::vector<Vec3> surface_tips(const Chart& chart);

}  // namespace quadrille::refine
