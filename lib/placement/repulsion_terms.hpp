#pragma once
// Nodes of opposite index attract each other without end, and so do a node and a corner whose charge
// beta = 4 - 2 pi V / omega (lib/method.md §8.3) has the other sign: there the energy has no minimum. A repulsion
// term is short-ranged and keeps such a pair apart:
//
//   2 pi |d beta| (reach / r - 1)^3   for r < reach, else 0
//
// With the pair's own attraction 2 pi |d beta| ln r it rests at r = 0.68 reach. The reach is half the pair's distance
// at the beginning, at most a part of the diameter: nodes that belong near each other, as at small fillets, may stay.

#include <optional>
#include <vector>

#include "model/cad_face.hpp"
#include "model/critical_points.hpp"

namespace quadrille::placement {

struct RepulsionTerm {
  int node = 0;
  std::optional<int> other;  ///< the other node; none: a corner or boundary node
  Vec2 position;             ///< of that corner
  double reach = 0;
  double strength = 0;  ///< 2 pi |d beta|
};

/// For all pairs of which one at least is free. `greatest_reach` in the file's unit.
std::vector<RepulsionTerm> repulsion_terms(const CadFace& face, const CriticalPoints& points,
                                           const std::vector<bool>& is_free, double greatest_reach);

/// The distance between the two.
double pair_distance(const RepulsionTerm& term, const CriticalPoints& points);

/// The value of the term; adds its gradient to `gradient`, which has an entry for each node.
double repulsion_energy(const RepulsionTerm& term, const CriticalPoints& points, std::vector<Vec2>& gradient);

}  // namespace quadrille::placement
