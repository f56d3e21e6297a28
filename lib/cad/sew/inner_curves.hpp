#pragma once
// Curves inside faces: which curves of a file are embedded, and the loops that they make in a region.

#include <vector>

#include "base/report.hpp"
#include "heal/heal_rules.hpp"
#include "heal/raw_face.hpp"
#include "sew/region.hpp"

namespace quadrille::sew {

/// A curve with the region on its left.
struct SideOfCurve {
  heal::LoopCurve curve;
  int from = 0, to = 0;  ///< nodes
  int twin = -1;         ///< the other side of an inner curve, in the opposite direction; -1: a curve of the boundary
};

/// The loops, as numbers of sides, each beginning with its lowest number: after each side comes the one that bounds the
/// same sector at its end, the next clockwise. Directions are compared a little away from the node, so that curves with
/// a common tangent have an order.
std::vector<std::vector<int>> traced_loops(const std::vector<SideOfCurve>& sides);

/// Moves to RawFace::inner_edges the wires that are not closed and do not go around the face, with a warning: they
/// bound nothing. A wire whose ends are nearer to each other than a tenth of its length stays: it has a gap.
void move_open_wires(heal::RawFace& raw, const heal::HealScale& scale, Report& report);

/// Those of the free edges of a file that lie in the regions, all of each, and not along their boundaries, without
/// tangent jumps inside. The others are ignored with a warning: construction lines.
std::vector<heal::LoopCurve> embedded_edges(const std::vector<Region>& regions, const std::vector<heal::RawEdge>& edges,
                                            const heal::HealScale& scale, Report& report);

/// The same for the inner edges of one face. Throws FormatError, with the place, for one that leaves the region.
std::vector<heal::LoopCurve> inner_curves(const Region& region, const std::vector<heal::RawEdge>& edges,
                                          const heal::HealScale& scale);

/// Throws FormatError, with place, size and remedy, if an end of an embedded curve nearly touches the boundary of a
/// region or another of the curves: further away than the tolerance, but not further than `most_slip`, a length.
void refuse_dangling_ends(const std::vector<Region>& regions, const std::vector<heal::LoopCurve>& curves,
                          const heal::HealScale& scale, double most_slip);

}  // namespace quadrille::sew
