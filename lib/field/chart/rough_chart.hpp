#pragma once
// A chart of the fine triangulation of a face by linear elements: where good triangles go.

#include "chart/intrinsic_triangles.hpp"
#include "chart/surface_mesh.hpp"
#include "model/cad_face.hpp"

namespace quadrille::chart {

/// The fine triangles of the face, of which only loops are used, with an image that keeps angles, and lengths on the
/// outline, up to the size of the triangles. Throws ComputeError if the triangulation is not connected.
SurfaceMesh rough_chart(const CadFace& face, const IntrinsicTriangles& fine);

}  // namespace quadrille::chart
