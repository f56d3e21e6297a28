#pragma once
// Midpoint division of degenerate corners (paper; lib/method.md §3).

#include "base/enum_names.hpp"
#include "model/cad_face.hpp"
#include "model/critical_points.hpp"

namespace quadrille::guide {

/// What becomes of corners that are too sharp for a block.
enum class DegeneratePolicy { divide, keep };
constexpr auto enum_names(DegeneratePolicy) {
  return std::to_array<EnumName<DegeneratePolicy>>(
      {{DegeneratePolicy::divide, "divide"}, {DegeneratePolicy::keep, "keep"}});
}

/// Corners of valence 0 and at least 15 degrees get valence 1 and a node of valence 3 on their bisector, at a quarter
/// of the clearance along it or half the shorter side. Two of its lines meet the corner's sides at right angles, the
/// third leads away from the corner. Sharper corners stay degenerate. Nodes and corners get the source `divide`, each
/// corner a change of that kind.
void divide_degenerate_corners(const CadFace& face, CriticalPoints& points);

}  // namespace quadrille::guide
