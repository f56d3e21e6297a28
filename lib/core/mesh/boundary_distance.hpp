#pragma once
// Distance between the boundary and interfaces of a quad mesh and the CAD curves, measured by projection in both
// directions. Where splines were replaced by nearby ones (CadFace::fit_distance), it is an upper bound of the distance
// from the curves in the CAD file: the greatest distance of the replacement is added.

#include "base/report.hpp"
#include "curve/face_boundary.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::mesh {

struct BoundaryDistance {
  curve::FarthestPoint mesh_to_cad;  ///< the point of an element's side that is farthest from all CAD curves
  curve::FarthestPoint cad_to_mesh;  ///< the point of a CAD curve that is farthest from all sides on the boundary

  const curve::FarthestPoint& worst() const {
    return cad_to_mesh.distance > mesh_to_cad.distance ? cad_to_mesh : mesh_to_cad;
  }
  /// Values within 1e-6 (relative) count as equal.
  bool is_within(double tolerance) const { return worst().distance <= tolerance * (1 + 1e-6); }
};

/// Samples 4 (N + 1) points of every side on the boundary, and as many of the CAD curves over the mean length of a side
/// (at least 8 in every knot span, and all joints and knots). Positions are relative to face.origin.
BoundaryDistance boundary_distance(const QuadMesh& mesh);

/// Reports both distances (boundary.*), and warns if one is above the tolerance, a length.
void report_distance(const BoundaryDistance& distance, const CadFace& face, double tolerance, Report& report);

}  // namespace quadrille::mesh
