#pragma once
// Generates the curved triangle mesh of a CAD face on which the field is solved.

#include "base/report.hpp"
#include "model/tri_mesh.hpp"
#include "triangulate/triangulate_options.hpp"

namespace quadrille::triangulate {

/// Sizes by curvature and local feature size, Delaunay refinement, fans at singular joints, curved elements, each
/// proved valid. Throws ComputeError, with the position, if this is impossible.
TriMesh triangulate(const CadFace& face, const TriangulateOptions& options, Report& report);

}  // namespace quadrille::triangulate
