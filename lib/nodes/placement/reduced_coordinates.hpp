#pragma once
// The variables of placement: node k = base + scale_k (movements y)_k, y the coefficients of the movements that keep
// the symmetry of the nodes. The scale of a node is its distance to the nearest boundary point or node, which makes all
// curvatures of the energy similar in size.

#include <Eigen/Core>
#include <vector>

#include "model/critical_points.hpp"
#include "placement/node_symmetry.hpp"
#include "placement/smooth_boundary_distance.hpp"

namespace quadrille::placement {

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
