#pragma once
// Where irregular nodes are put: the least energy of the phase form (phase-field.md point 9) plus a term that keeps
// them off the boundary.
//
//   F(a) = W(a) - w pi sum_k d_k^2 ln delta(a_k),   delta(x) = pi / oint ds / |x - y(s)|^2
//
// delta is a smooth distance to the boundary: the distance to a straight wall, (R^2 - r^2) / (2 R) in a disc.

#include <functional>
#include <vector>

#include "base/report.hpp"
#include "model/cad_face.hpp"
#include "model/critical_points.hpp"

namespace quadrille {

/// W(a) and its gradient for each node of critical_points.
struct NodeEnergy {
  double value = 0;
  std::vector<Vec2> gradient;
};
/// Throws ComputeError where a node is not inside the domain.
using EnergyFunction = std::function<NodeEnergy(const CriticalPoints& points)>;

struct PlacementOptions {
  double weight = 1.4;       ///< w; 0: the pure energy
  double tolerance = 1e-10;  ///< of the nodes' places, share of the diameter
  int max_iterations = 200;
};

/// ln delta(x) and its gradient. Linear in the number of curves.
double log_wall_distance(const CadFace& face, Vec2 x, Vec2& gradient);

/// Moves the nodes with is_free[k] to a minimum of F, the others stay. Symmetric sets of nodes stay symmetric.
/// Adds a change of the kind "place" for each that moved by more than the tolerance.
void place_nodes(const CadFace& face, const EnergyFunction& energy, const std::vector<bool>& is_free,
                 const PlacementOptions& options, CriticalPoints& points, Report& report);

}  // namespace quadrille
