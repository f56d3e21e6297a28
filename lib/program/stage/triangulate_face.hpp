#pragma once
// The triangle mesh of a face, each of its regions by itself.

#include "base/run.hpp"
#include "model/tri_mesh.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille::stage {

/// The mesh (triangulate/triangulate.hpp) without provenance and repairs; elements on both sides of a common curve
/// have the same edges. Throws ComputeError, with the region and the position, if no valid mesh is found.
TriMesh triangulate_face(const CadFace& face, const triangulate::TriangulateOptions& options, Run& run);

}  // namespace quadrille::stage
