#pragma once
// The function that placement minimises: the energy of the phase form, the boundary term and the repulsion terms
// (formula in placement/place_nodes).
//
// Nodes of opposite index attract each other without limit, and so do a node and a corner whose charge beta = 4 - 2 pi
// V / omega (lib/method.md §8.3) has the other sign: the energy has no minimum there. A short-ranged repulsion term
// keeps such a pair apart:
//
//   2 pi |d beta| (reach / r - 1)^3   for r < reach, else 0
//
// Together with the pair's own attraction 2 pi |d beta| ln r, its minimum is at r = 0.68 reach. The reach is half of
// the pair's initial distance, at most a fraction of the diameter: nodes that belong near each other, as at small
// fillets, may stay.

#include <functional>
#include <optional>
#include <vector>

#include "model/cad_face.hpp"
#include "model/critical_points.hpp"
#include "placement/smooth_boundary_distance.hpp"

namespace quadrille::placement {

struct RepulsionTerm {
  int node = 0;
  std::optional<int> other;  ///< the other node; std::nullopt: a corner or boundary node
  Vec2 position;             ///< of that corner or boundary node
  double reach = 0;
  double strength = 0;  ///< 2 pi |d beta|
};

/// The terms of all pairs with at least one free node. `greatest_reach` in the file's unit.
std::vector<RepulsionTerm> repulsion_terms(const CadFace& face, const CriticalPoints& points,
                                           const std::vector<bool>& is_free, double greatest_reach);

/// The distance between the node and its partner.
double pair_distance(const RepulsionTerm& term, const CriticalPoints& points);

/// The value of the term; adds its gradient to `gradient`, which has an entry for each node.
double repulsion_energy(const RepulsionTerm& term, const CriticalPoints& points, std::vector<Vec2>& gradient);

/// W(a) and its gradient for each node of critical_points.
struct NodeEnergy {
  double value = 0;
  std::vector<Vec2> gradient;
};
/// Throws ComputeError if a node is not inside the domain.
using EnergyFunction = std::function<NodeEnergy(const CriticalPoints& points)>;

/// lambda of a chart, the logarithm of a length in space over one in the chart, with its gradient; empty in a plane.
using LogScale = std::function<double(Vec2 x, Vec2& gradient)>;

/// The mean of e^lambda on the straight line from x, inside the face, to y, or its first part inside, at three Gauss
/// points: a length in space over that in the chart. 1 in a plane.
double mean_scale(const LogScale& log_scale, const curve::FaceBoundary& boundary, Vec2 x, Vec2 y);

struct PlacementObjective {
  const EnergyFunction& energy;
  const SmoothBoundaryDistance& boundary;
  double weight = 0;      ///< of the boundary term
  std::vector<int> free;  ///< nodes that have a boundary term and one of the chart
  std::vector<RepulsionTerm> repulsion;
  LogScale log_scale = {};

  /// The value and its gradient for each node. Throws the errors of the energy.
  NodeEnergy at(const CriticalPoints& points) const;
  /// The greatest fraction, at most 1, of these moves of all nodes that is allowed at once: no node covers more than
  /// half of its distance to the boundary, to another node or to a corner that attracts it.
  double allowed_part(const CriticalPoints& points, const std::vector<Vec2>& moves) const;
};

}  // namespace quadrille::placement
