#pragma once
// Curved faces on which a reflection in space exchanges two lines of the boundary, as of tubes with two equal ends. In
// the chart this symmetry is an inversion, no isometry, so that a mesh that is made there has it only up to the size of
// its elements. The lifted mesh gets it here: each node moves to the mean of itself and the image of its partner.

#include <optional>

#include "mesh/chart_map.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::refine {

/// The reflection at a plane.
struct SpaceMirror {
  Vec3 middle, normal;  ///< `normal` of length 1

  Vec3 operator()(Vec3 x) const { return x - 2 * dot(x - middle, normal) * normal; }
};

/// The first one counts whose exchange with that of the first curve maps all curves, and the surface, onto themselves
/// within 1e-6 diameters. Cost: a projection for each triangle of the chart if the curves are mapped onto themselves.
std::optional<SpaceMirror> end_mirror(const mesh::ChartMap& map, const CadFace& face);

/// Moves the nodes of a lifted mesh, in space and in the chart. Nodes on boundary and interface edges stay on their
/// curves. Does nothing if the reflection does not map elements onto elements.
void symmetrise(const mesh::ChartMap& map, const SpaceMirror& mirror, QuadMesh& mesh);

}  // namespace quadrille::refine
