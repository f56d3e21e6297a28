#pragma once
// The variables of placement: node k = base + scale_k (movements y)_k, y the coefficients of the movements that keep
// the symmetry of the nodes. The scale of a node is its distance to the next boundary point or node: then all
// curvatures of the energy are of one size.

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

  /// The movement of every node; that of one which is not free is 0.
  std::vector<Vec2> movement(const Eigen::VectorXd& y) const;
  /// The nodes moved by y.
  CriticalPoints moved(const CriticalPoints& base, const Eigen::VectorXd& y) const;
  /// The gradient by y of a function whose gradient by the nodes is given.
  Eigen::VectorXd gradient(const std::vector<Vec2>& by_nodes) const;
};

/// The scales of all nodes, the mean over the nodes that are images of each other; 0 for those that are not free.
std::vector<double> length_scales(const SmoothBoundaryDistance& boundary, const CriticalPoints& points,
                                  const std::vector<int>& free, const std::vector<NodeSymmetry>& group);

}  // namespace quadrille::placement
