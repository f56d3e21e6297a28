#pragma once
// Corner valences and irregular nodes by rule (lib/method.md §3), for faces whose field does not determine them: it
// vanishes on curves, as where all sides are straight at multiples of 45 degrees.
//
// A corner within 2 degrees of 135, 225 or 315 degrees may have either integer next to 2 omega / pi. (A corner of 45
// degrees has V = 1: V = 0 is no block, and an interior node can always replace it.) All start with the larger; each
// smaller valence raises sum (2 - V) by one. Symmetry orbits of corners are decided as a whole. Among the choices with
// sum (2 - V) = 4 chi:
//   1. the least angle defect, sum V |omega / V - 90 degrees|^2,
//   2. smaller valences where the adjacent sides are longest (the sum over these corners),
//   3. smaller valences farthest from the face's centroid,
// each equal within 1e-6 of its scale; then the corners that come first in the file.

#include <vector>

#include "curve/symmetry.hpp"
#include "model/cad_face.hpp"
#include "model/critical_points.hpp"

namespace quadrille::guide {

struct LineCorners {
  std::vector<Corner> corners;  ///< in the order of the joints; ties have the source `line`, others `angle`
  int missing_index = 0;        ///< 4 chi - sum (2 - V); not 0: no symmetric choice fits, ties have the larger V
};

/// The valence of every corner by its angle alone; orbits of ties under `group`, the isometries of the face, get the
/// smaller or the larger valence such that the index sum holds without a node, if a symmetric choice exists.
LineCorners line_corners(const CadFace& face, const std::vector<curve::Isometry>& group);

/// For a face whose field has no zeros that can be isolated, as where its boundary data lie on one line
/// (field/boundary_values, is_line_field): corner valences by rule. If no symmetric choice fits, all ties have the
/// larger valence, and nodes (guide/resolve_clusters) are added about the rotation centre, or about the most interior
/// point that is invariant under the symmetries of the face. No elements are set.
CriticalPoints line_field_points(const CadFace& face, int max_valence);

}  // namespace quadrille::guide
