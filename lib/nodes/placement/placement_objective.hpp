#pragma once
// The function that placement minimises: the energy of the phase form, the boundary term and the repulsion terms
// (formula in placement/place_nodes).

#include <functional>
#include <vector>

#include "model/cad_face.hpp"
#include "model/critical_points.hpp"
#include "placement/repulsion_terms.hpp"
#include "placement/smooth_boundary_distance.hpp"

namespace quadrille::placement {

/// W(a) and its gradient for each node of critical_points.
struct NodeEnergy {
  double value = 0;
  std::vector<Vec2> gradient;
};
/// Throws ComputeError if a node is not inside the domain.
using EnergyFunction = std::function<NodeEnergy(const CriticalPoints& points)>;

struct PlacementObjective {
  const EnergyFunction& energy;
  const SmoothBoundaryDistance& boundary;
  double weight = 0;      ///< of the boundary term
  std::vector<int> free;  ///< nodes that have a boundary term
  std::vector<RepulsionTerm> repulsion;

  /// The value and its gradient for each node. Throws the errors of the energy.
  NodeEnergy at(const CriticalPoints& points) const;
  /// The greatest fraction, at most 1, of these moves of all nodes that is allowed at once: no node covers more than
  /// half of its distance to the boundary, to another node or to a corner that attracts it.
  double allowed_part(const CriticalPoints& points, const std::vector<Vec2>& moves) const;
};

}  // namespace quadrille::placement
