#pragma once
// One chord of blocks taken out of a layout: the two ends of each rung become one node, the two rails one line.
//
// Pins (graph/chord_strip.hpp) stay where they are. Between pins of one side the rail of that side is kept as it is;
// before the first and after the last pin as well, so that a line ends on the boundary where it did. Between pins of
// different sides the rails are blended (simplify/chord_blend.hpp). All lines that cross the strip stay where they are:
// where the new line crosses a rung, the arcs on both sides of the rung are lengthened by its parts. So nothing turns
// away from the field but the blends, and every inner arc stays a part of one spline.

#include <optional>
#include <vector>

#include "graph/chord_strip.hpp"
#include "simplify/chord_blend.hpp"

namespace quadrille::simplify {

struct Collapse {
  SeparatrixGraph graph;         ///< without the strip; `lines` as in lines_of_arcs
  std::vector<int> arc2arc;      ///< the new arc of each old one, -1 for rungs
  std::vector<bool> is_changed;  ///< of the new arcs: another shape than before
};

/// The blends that a strip needs. Nothing where one would turn too far or replace a part of the boundary.
/// `pins` = pins_of(graph, strip), not empty, here and below.
std::optional<std::vector<Blend>> blends_of(const field::FieldEvaluator& evaluator, const SeparatrixGraph& graph,
                                            const graph::ChordStrip& strip, const std::vector<graph::Pin>& pins,
                                            const BlendOptions& options);

/// `blends` are those of the strip, others may be among them; made before other strips that cross it were collapsed,
/// they stay what they were, and so the sequence of strips does not matter. Nothing where one is missing or does not
/// cross the rungs one after the other.
std::optional<Collapse> collapse_strip(const SeparatrixGraph& graph, const graph::ChordStrip& strip,
                                       const std::vector<graph::Pin>& pins, const std::vector<Blend>& blends);

/// Every inner arc being a part of one spline: for each spline a line for each run of arcs, of the kind that `kinds`
/// has for the spline.
std::vector<SeparatrixLine> lines_of_arcs(const SeparatrixGraph& graph, const std::vector<std::string>& kinds);

/// The kind of the line of each spline of a graph; "traced" where none uses it.
std::vector<std::string> spline_kinds(const SeparatrixGraph& graph);

/// Leaves out splines that no arc uses.
void drop_unused_splines(SeparatrixGraph& graph);

}  // namespace quadrille::simplify
