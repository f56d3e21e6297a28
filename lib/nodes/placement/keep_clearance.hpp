#pragma once
// Irregular nodes keep a distance from walls, so that layers fit below them: those that are too near move the shortest
// way out.
//
// Each such node moves to the nearest point at which it has the clearance of all walls, and keeps half of its distance
// to other nodes and to boundaries without layers. It moves at most by what it misses: farther moves would change which
// lines of the field meet. Where there is no such point, it misses all clearances by the same amount, the least
// possible. The other nodes stay.
//
// The distances are linearised (placement/half_planes) and all nodes move at once, in rounds, so that symmetric sets
// stay symmetric. The energy of the nodes is not used: it depends on all pairs of nodes and boundary elements, and its
// minimum under these conditions gives no better blocks.

#include <vector>

#include "base/report.hpp"
#include "model/cad_face.hpp"
#include "model/critical_points.hpp"
#include "placement/wall_clearance.hpp"

namespace quadrille::placement {

/// Moves the nodes with may_move[k] that are nearer to a wall than its clearance, and records the moves
/// (placement/record_moves). Report: clearance.moved, clearance.missed (numbers of nodes). Warning: W-PLACE-003 if
/// nodes miss more than a tenth of a clearance. Cost: linear in the number of nodes and curves for each node that
/// moves.
void keep_clearance(const CadFace& face, const std::vector<WallClearance>& walls, const std::vector<bool>& may_move,
                    CriticalPoints& points, Report& report);

}  // namespace quadrille::placement
