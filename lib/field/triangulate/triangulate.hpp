#pragma once
// Generates the curved triangle mesh of a CAD face on which the field is solved.

#include <functional>
#include <vector>

#include "base/report.hpp"
#include "model/tri_mesh.hpp"

namespace quadrille::triangulate {

struct TriangulateOptions {
  int order = 8;             ///< shape order N, 1..16: proofs are exact to round-off up to degree 2N - 2 = 30
  double size = 0;           ///< greatest element size in file units; 0: diameter / 4
  double growth = 0.5;       ///< Lipschitz constant of the size field (0, 2]
  double curve_tol = 1e-12;  ///< greatest distance between element edges and curves, relative to the diameter
  int fan_layers = -1;       ///< layers of a corner fan; -1: chosen by the exponent at the corner
  double fan_factor = 0.15;  ///< ratio of the radii of successive layers (0, 1)
  void validate() const;     ///< throws UsageError
};

/// Which elements of a mesh are not fit for a purpose of the caller, ascending: a further reason to refine them.
using Doubts = std::function<std::vector<int>(const TriMesh&)>;

/// Sizes by curvature and local feature size, Delaunay refinement, fans at singular joints, curved elements, each
/// proved valid. Elements that `doubts` names are refined as well; some may remain. On slits and on interfaces of
/// regions the elements of both sides have the same edges. Throws ComputeError, with the position, if no valid mesh is
/// found.
TriMesh triangulate(const CadFace& face, const TriangulateOptions& options, Report& report, const Doubts& doubts = {});

/// Few triangles of a face, also of several regions, for midpoint division (midpoint/midpoint_graph.hpp): no fans at
/// singular corners, and no limit to the distance from the curves, which the blocks follow exactly. Triangles that
/// `doubts` names are refined. Throws ComputeError if there are none.
TriMesh coarse_triangles(const CadFace& face, const Doubts& doubts, Report& report);

}  // namespace quadrille::triangulate
