#pragma once
// Midpoint division of degenerate corners (paper; lib/method.md §3).

#include "base/enum_names.hpp"
#include "model/cad_face.hpp"
#include "model/critical_points.hpp"

namespace quadrille::guide {

/// Treatment of corners that are too sharp for a block: midpoint division, or none.
enum class DegeneratePolicy { divide, keep };
constexpr auto enum_names(DegeneratePolicy) {
  return std::to_array<EnumName<DegeneratePolicy>>(
      {{DegeneratePolicy::divide, "divide"}, {DegeneratePolicy::keep, "keep"}});
}

/// Corners of valence 0 and at least 15 degrees get valence 1 and a node of valence 3 on their bisector, at a distance
/// of a quarter of the clearance along it, at most half the shorter side and half the distance to any other node. Two
/// of the node's lines meet the corner's sides at right angles, the third leads away from the corner. Sharper corners
/// stay degenerate. Nodes and corners get the source `divide`; each corner is recorded as a change of that kind.
void divide_degenerate_corners(const CadFace& face, CriticalPoints& points);

}  // namespace quadrille::guide
