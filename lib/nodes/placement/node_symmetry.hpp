#pragma once
// The isometries of a face that map its nodes onto each other, and the movements of nodes that keep these symmetries.
//
// The variables of placement: node k = base + scale_k (movements y)_k, y the coefficients of the movements that keep
// the symmetry of the nodes. The scale of a node is its distance to the nearest boundary point or node, which makes all
// curvatures of the energy similar in size.

#include <Eigen/Core>
#include <vector>

#include "curve/symmetry.hpp"
#include "model/cad_face.hpp"
#include "model/critical_points.hpp"
#include "placement/smooth_boundary_distance.hpp"

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

struct ReducedCoordinates {
  std::vector<int> free;       ///< the nodes that move, ascending
  Eigen::MatrixXd movements;   ///< invariant movements (placement/node_symmetry), one in each column
  std::vector<double> scales;  ///< of all nodes

  /// The movement of every node; 0 for a node that is not free.
  std::vector<Vec2> movement(const Eigen::VectorXd& y) const;
  /// The nodes moved by y.
  CriticalPoints moved(const CriticalPoints& base, const Eigen::VectorXd& y) const;
  /// The gradient with respect to y of a function with the gradient `by_nodes` with respect to the nodes.
  Eigen::VectorXd gradient(const std::vector<Vec2>& by_nodes) const;
};

/// The scales of all nodes, averaged over nodes that are images of each other; 0 for nodes that are not free.
std::vector<double> length_scales(const SmoothBoundaryDistance& boundary, const CriticalPoints& points,
                                  const std::vector<int>& free, const std::vector<NodeSymmetry>& group);

}  // namespace quadrille::placement
