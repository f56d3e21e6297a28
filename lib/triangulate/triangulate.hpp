#pragma once
// From a CAD face to the curved triangle mesh that the field is solved on.

#include "base/report.hpp"
#include "model/tri_mesh.hpp"
#include "triangulate/triangulate_options.hpp"

namespace quadrille::triangulate {

/// Sizes by curvature and local feature size, Delaunay refinement, fans at singular joints, curved elements, each
/// proved valid. Throws ComputeError with the place where that is impossible.
TriMesh triangulate(const CadFace& face, const TriangulateOptions& options, Report& report);

}  // namespace quadrille::triangulate
