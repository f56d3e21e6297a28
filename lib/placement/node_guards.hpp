#pragma once
// Nodes of opposite index attract each other without end, and so do a node and a corner whose charge
// beta = 4 - 2 pi V / omega (lib/method.md §8.3) has the other sign: there the energy has no minimum. A guard is a
// short-ranged term that keeps such a pair apart:
//
//   2 pi |d beta| (reach / r - 1)^3   for r < reach, else 0
//
// With the pair's own attraction 2 pi |d beta| ln r it rests at r = 0.68 reach. The reach is half the pair's distance
// at the beginning, at most a share of the diameter: nodes that belong near each other, as at small fillets, may stay.

#include <vector>

#include "model/cad_face.hpp"
#include "model/critical_points.hpp"

namespace quadrille::placement {

struct NodeGuard {
  int node = 0;
  int other = -1;  ///< the other node, or -1: a corner or boundary node
  Vec2 place;      ///< of that corner
  double reach = 0;
  double strength = 0;  ///< 2 pi |d beta|
};

/// For all pairs of which one at least is free. `greatest_reach` in the file's unit.
std::vector<NodeGuard> node_guards(const CadFace& face, const CriticalPoints& points, const std::vector<bool>& is_free,
                                   double greatest_reach);

/// How far the two are from each other.
double guarded_distance(const NodeGuard& guard, const CriticalPoints& points);

/// The term, and what it adds to the gradient for each node.
double guard_energy(const NodeGuard& guard, const CriticalPoints& points, std::vector<Vec2>& gradient);

}  // namespace quadrille::placement
