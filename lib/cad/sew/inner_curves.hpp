#pragma once
// Which curves of a file are embedded in its faces.

#include <vector>

#include "base/report.hpp"
#include "heal/heal_scale.hpp"
#include "heal/raw_face.hpp"
#include "sew/region.hpp"

namespace quadrille::sew {

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
