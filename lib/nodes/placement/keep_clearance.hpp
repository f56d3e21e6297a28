#pragma once
// Irregular nodes keep a distance from walls, so that layers fit below them: those that are too near move the shortest
// way out.
//
// Each such node moves to the nearest point at which it has the clearance of all walls, and keeps half of its distance
// to other nodes and to boundaries without layers. It moves at most by what it misses: farther moves would change which
// lines of the field meet. Where there is no such point, it misses all clearances by the same amount, the least
// possible. The other nodes stay.
//
// In a chart clearances, and what a node misses and moves, are lengths in space of straight lines of the chart, the
// integral of e^lambda, as heights of layers are (lib/method.md §12).
//
// Two nodes on a mirror axis cannot pass each other. Where they miss a clearance, they are also moved out from the
// positions of the turned pair (placement/axis_pairs), and take those if they miss less so.
//
// The distances are linearised (placement/half_planes) and all nodes move at once, in rounds, so that symmetric sets
// stay symmetric. The energy of the nodes is not used: it depends on all pairs of nodes and boundary elements, and its
// minimum under these conditions gives no better blocks.

#include <string>
#include <vector>

#include "base/report.hpp"
#include "model/cad_face.hpp"
#include "model/critical_points.hpp"
#include "placement/placement_objective.hpp"

namespace quadrille::placement {

/// Boundary curves from which nodes keep a distance.
struct WallClearance {
  std::vector<int> curves;
  double clearance = 0;  ///< a length, in space
};

/// NAME=L of the command line.
struct NamedClearance {
  std::string name;
  double clearance = 0;
};

/// Throws UsageError with the text, if it is not NAME=L with L > 0.
NamedClearance parse_clearance(const std::string& text);

/// Throws UsageError for names that no boundary of the face has.
std::vector<WallClearance> wall_clearances(const CadFace& face, const std::vector<NamedClearance>& named);

/// By curve: the clearance of its wall, the greatest if there are several; 0: none.
std::vector<double> clearance_of_curves(const CadFace& face, const std::vector<WallClearance>& walls);

/// Moves the nodes with may_move[k] that are nearer to a wall than its clearance, and records the moves
/// (placement/node_ledger). `log_scale`: of the chart; empty in a plane. Report: clearance.moved, clearance.missed
/// (numbers of nodes). Warning: W-PLACE-003 if nodes miss more than a tenth of a clearance. Cost: linear in the number
/// of nodes and curves for each node that moves.
void keep_clearance(const CadFace& face, const std::vector<WallClearance>& walls, const LogScale& log_scale,
                    const std::vector<bool>& may_move, CriticalPoints& points, Report& report);

}  // namespace quadrille::placement
