#pragma once
// Collapses one chord of blocks of a layout: the two ends of each rung become one node, the two rails one line.
//
// Fixed nodes do not move; simplify/collapse_plan.hpp decides which rail is kept and which rails are blended. All lines
// that cross the strip keep their curves: where the new line crosses a rung, the arcs on both sides of the rung are
// lengthened by its parts. So only the blends deviate from the field, and every inner arc stays a part of one spline.

#include <optional>
#include <vector>

#include "graph/chord_strip.hpp"
#include "simplify/chord_blend.hpp"

namespace quadrille::simplify {

/// The blends that a strip needs. std::nullopt if one would deviate too far or replace a part of the boundary. `fixed`
/// = graph::fixed_sides(subdivision, strip), not empty, here and below.
std::optional<std::vector<Blend>> blends_of(const field::FieldEvaluator& evaluator,
                                            const graph::Subdivision& subdivision, const graph::ChordStrip& strip,
                                            const std::vector<graph::FixedSide>& fixed, const BlendOptions& options);

/// The arcs after a collapse.
struct ArcChanges {
  std::vector<int> arc2arc;      ///< the new arc of each old one: for a removed rail the other rail, for rungs -1
  std::vector<bool> is_changed;  ///< by new arc: its shape has changed
};

/// Collapses a strip; the subdivision is compact again. `blends` must include those of the strip. They may have been
/// computed before other strips that cross it were collapsed, so the result does not depend on the order of strips.
/// std::nullopt, without any change, if one is missing or does not cross the rungs in order.
std::optional<ArcChanges> collapse_strip(graph::Subdivision& subdivision, const graph::ChordStrip& strip,
                                         const std::vector<graph::FixedSide>& fixed, const std::vector<Blend>& blends);

}  // namespace quadrille::simplify
