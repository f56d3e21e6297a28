#pragma once
// The isometries of a face that map its nodes onto each other, and the movements of nodes that keep these symmetries.

#include <Eigen/Core>
#include <vector>

#include "curve/symmetry.hpp"
#include "model/cad_face.hpp"
#include "model/critical_points.hpp"

namespace quadrille::placement {

/// An isometry that maps node k onto node image[k].
struct NodeSymmetry {
  curve::Isometry isometry;
  Mat2 linear;  ///< its rotation or reflection
  std::vector<int> image;
};

/// The isometries of the face that keep nodes with their valences and is_free, corners with their valences and boundary
/// nodes, all within 1e-6 diameters. The identity is first; it is the only one if there are hole winding offsets.
std::vector<NodeSymmetry> node_symmetries(const CadFace& face, const CriticalPoints& points,
                                          const std::vector<bool>& is_free);

/// Moves each free node to the mean of the images that should coincide with it.
void symmetrise(const std::vector<NodeSymmetry>& group, const std::vector<bool>& is_free, CriticalPoints& points);

/// Orthonormal columns that span the invariant movements: entries 2 i and 2 i + 1 are x and y of free node i, relative
/// to the node's own length scale (which is the same for nodes that are images of each other).
Eigen::MatrixXd invariant_movements(const std::vector<NodeSymmetry>& group, const std::vector<bool>& is_free);

}  // namespace quadrille::placement
