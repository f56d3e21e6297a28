#pragma once
// Midpoint division of degenerate corners (paper; lib/method.md §3).

#include "base/enum_names.hpp"
#include "base/report.hpp"
#include "model/cad_face.hpp"
#include "model/critical_points.hpp"

namespace quadrille::guide {

/// Treatment of corners that are too sharp for a block: midpoint division, or none.
enum class DegeneratePolicy { divide, keep };
constexpr auto enum_names(DegeneratePolicy) { return std::to_array({"divide", "keep"}); }

/// Corners of valence 0 get valence 1 and a node of valence 3 in the middle of their wedge, at a distance of a quarter
/// of the wedge's length, at most half the shorter side, half the distance to any other node, and what a bent wedge
/// allows (guide/middle_line). Two of the node's lines meet the corner's sides at right angles, the third leads away
/// from the corner. Nodes and corners get the source `divide`; each corner is recorded as a change of that kind.
void divide_degenerate_corners(const CadFace& face, CriticalPoints& points);

/// Warns of corners below 15 degrees that have a block: no element there has a scaled Jacobian above the sine of the
/// angle.
void report_sharp_corners(const CadFace& face, const CriticalPoints& points, Report& report);

}  // namespace quadrille::guide
