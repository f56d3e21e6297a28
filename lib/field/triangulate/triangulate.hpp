#pragma once
// Generates the curved triangle mesh of a CAD face on which the field is solved.

#include <functional>
#include <vector>

#include "base/report.hpp"
#include "model/tri_mesh.hpp"
#include "triangulate/triangulate_options.hpp"

namespace quadrille::triangulate {

/// Which elements of a mesh are not fit for a purpose of the caller, ascending: a further reason to refine them.
using Doubts = std::function<std::vector<int>(const TriMesh&)>;

/// Sizes by curvature and local feature size, Delaunay refinement, fans at singular joints, curved elements, each
/// proved valid. Elements that `doubts` names are refined as well; some may remain. On slits and on interfaces of
/// regions the elements of both sides have the same edges. Throws ComputeError, with the position, if no valid mesh is
/// found.
TriMesh triangulate(const CadFace& face, const TriangulateOptions& options, Report& report, const Doubts& doubts = {});

/// Few triangles of a face, also of several regions, for midpoint division (layout/midpoint_layout.hpp): no fans at
/// singular corners, and no limit to the distance from the curves, which the blocks follow exactly. Triangles that
/// `doubts` names are refined. Throws ComputeError if there are none.
TriMesh coarse_triangles(const CadFace& face, const Doubts& doubts, Report& report);

}  // namespace quadrille::triangulate
