#pragma once
// One chord of blocks taken out of a layout: the two ends of each rung become one node, the two rails one line.
//
// Fixed nodes stay where they are; simplify/collapse_plan.hpp says which rail is kept and where rails are blended. All
// lines that cross the strip stay where they are: where the new line crosses a rung, the arcs on both sides of the rung
// are lengthened by its parts. So nothing deviates from the field but the blends, and every inner arc stays a part of
// one spline.

#include <optional>
#include <vector>

#include "graph/chord_strip.hpp"
#include "simplify/chord_blend.hpp"

namespace quadrille::simplify {

/// The blends that a strip needs. Empty where one would deviate too far or replace a part of the boundary.
/// `fixed` = graph::fixed_sides(subdivision, strip), not empty, here and below.
std::optional<std::vector<Blend>> blends_of(const field::FieldEvaluator& evaluator,
                                            const graph::Subdivision& subdivision, const graph::ChordStrip& strip,
                                            const std::vector<graph::FixedSide>& fixed, const BlendOptions& options);

/// What became of the arcs.
struct ArcChanges {
  std::vector<int> arc2arc;      ///< the new arc of each old one: of a removed rail the other one, of rungs -1
  std::vector<bool> is_changed;  ///< of the new arcs: another shape than before
};

/// Collapses a strip; the subdivision is compact again. `blends` are those of the strip, others may be among them; made
/// before other strips that cross it were collapsed, they stay what they were, and so the order of strips does not
/// matter. Empty, and nothing is changed, where one is missing or does not cross the rungs one after the other.
std::optional<ArcChanges> collapse_strip(graph::Subdivision& subdivision, const graph::ChordStrip& strip,
                                         const std::vector<graph::FixedSide>& fixed, const std::vector<Blend>& blends);

}  // namespace quadrille::simplify
