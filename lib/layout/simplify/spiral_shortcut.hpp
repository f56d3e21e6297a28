#pragma once
// Shortens spirals. A separatrix that starts at P, passes a node Q side by side with the line that ends there, and ends
// at Q only a full turn later, is replaced by a blend (simplify/chord_blend.hpp) from P to Q over the part before the
// turn. Blocks that the turn divided in two are united; the lines that it crossed are not changed. Chord collapse
// cannot achieve this: the chord beside such a line crosses itself.

#include <optional>
#include <vector>

#include "graph/chord_strip.hpp"
#include "simplify/chord_blend.hpp"

namespace quadrille::simplify {

/// Blocks of a strip between a fixed node at one side of a rung and the next at the other side, where both rails are
/// the two ends of one line between these nodes.
struct SpiralShortcut {
  int spline = 0;                            ///< of the line, in the graph's splines
  std::vector<HalfEdge> rungs, left, right;  ///< as in ChordStrip
  bool from_left = true;                     ///< P is the left end of the first rung
  double aspect = 0;                         ///< mean length of the rungs over the mean length of the rails
};

/// All shortcuts, in the order of their strips.
std::vector<SpiralShortcut> find_shortcuts(const graph::Subdivision& subdivision, const std::vector<double>& lengths);

/// std::nullopt if it would deviate too far.
std::optional<Blend> blend_of(const field::FieldsOfRegions& fields, const ArcGraph& graph,
                              const SpiralShortcut& shortcut, const BlendOptions& options);

/// The compact subdivision in which the blend (of this line, also if the layout has changed since) replaces the line;
/// std::nullopt if the blend does not fit. Its faces may have other numbers of corners than four.
std::optional<graph::Subdivision> with_shortcut(graph::Subdivision subdivision, const SpiralShortcut& shortcut,
                                                const Blend& blend);

}  // namespace quadrille::simplify
