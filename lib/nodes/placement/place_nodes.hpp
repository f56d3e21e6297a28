#pragma once
// Placement of irregular nodes: the least energy of the phase form (lib/method.md §8.9) plus a term that repels them
// from the boundary.
//
//   F(a) = W(a) - w pi sum_k d_k^2 ln delta(a_k),   delta(x) = pi / oint ds / |x - y(s)|^2
//
// delta (placement/smooth_boundary_distance) is a smooth distance to the boundary, in one half of a symmetric whole to
// that of the whole: then F is half of the whole's, whose phase is constant on the line of symmetry. On a disc of
// radius R four nodes have their minimum at the radius r R, q = r^2, with 8 q^4 / (1 - q^4) + 2 w q / (1 - q) = 3:
// 0.850 for w = 0, 0.691 for w = 1.4, 0.640 for w = 2.
//
// In a chart (lib/method.md §12) delta is that of the chart, and each node has the term of the surface's energy
//
//   pi d_k (d_k - 8) lambda(a_k)
//
// besides, so that blocks have even sizes on the surface: it moves nodes of valence 3 to where lengths in space are
// greater than in the chart, those of valence 5 to where they are smaller. On the half sphere four nodes have their
// minimum for w = 0 at the corners of a cube, r = (sqrt 3 - 1) / sqrt 2 in the stereographic chart.
//
// The default weight suits most blocks of tests/benchmarks/placement: nodes within a tenth of the diameter of the
// boundary stay as far from it as the zeros of the field (within 4 %) or move farther away, most of all next to a
// strongly curved boundary; the worst angles of blocks are no worse on any shape there; greater weights push pairs of
// opposite index together. Lines that met head-on between the zeros of the field may then miss each other, which costs
// blocks: therefore the zeros are moved only with --place energy.
//
// Nodes of opposite index attract each other, as may a node and a corner whose valence is not the natural one: such
// pairs are kept apart (placement/placement_objective) and reported.

#include <string>
#include <vector>

#include "base/enum_names.hpp"
#include "base/report.hpp"
#include "model/cad_face.hpp"
#include "model/critical_points.hpp"
#include "placement/placement_objective.hpp"

namespace quadrille::placement {

/// Which nodes are placed. `keep`: those without a position of their own; `energy`: all.
enum class PlaceRule { keep, energy };
constexpr auto enum_names(PlaceRule) { return std::to_array({"keep", "energy"}); }

struct PlacementOptions {
  double weight = 2;         ///< w >= 0; 0: the pure energy
  double tolerance = 1e-10;  ///< of the nodes' positions, relative to the diameter
  int max_iterations = 200;  ///< each takes a few evaluations of the energy at most
  double pair_reach = 0.02;  ///< greatest reach of a repulsion term, relative to the diameter
  /// Patterns of the names of curves at lines of symmetry (curve/symmetry_lines.hpp), which are no boundary of the
  /// whole.
  std::vector<std::string> symmetry = {};
  LogScale log_scale = {};  ///< lambda of a curved face's chart
};

/// Moves the nodes with is_free[k] to a minimum of F near their positions; the others stay. Nodes that are invariant
/// under symmetries of the face remain so (and are a minimum among such sets). Records the moves
/// (placement/node_ledger). Report: placement.{energy_before, energy_after, iterations, evaluations, last_step,
/// symmetries, least_curvature}. Warnings: W-PLACE-001 not converged, W-PLACE-002 a pair that would meet. Throws the
/// errors of the energy at the start.
void place_nodes(const CadFace& face, const EnergyFunction& energy, const std::vector<bool>& is_free,
                 const PlacementOptions& options, CriticalPoints& points, Report& report);

}  // namespace quadrille::placement
