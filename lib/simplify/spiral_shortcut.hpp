#pragma once
// Spirals shortened. A separatrix that starts at P, passes a node Q side by side with the line that arrives there, and
// arrives at Q only a full turn later, is replaced by a blend (simplify/chord_blend.hpp) from P to Q over that first
// stretch. What the turn divided in two is one block again; the lines that it crossed continue as they were. No chord
// collapse could do that: the chord beside such a line crosses itself.

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
  double aspect = 0;                         ///< mean length of the rungs over that of the rails
};

/// All, in the order of their strips.
std::vector<SpiralShortcut> find_shortcuts(const graph::Subdivision& subdivision, const std::vector<double>& lengths);

/// Empty where it would deviate too far.
std::optional<Blend> blend_of(const field::FieldEvaluator& evaluator, const ArcGraph& graph,
                              const SpiralShortcut& shortcut, const BlendOptions& options);

/// The subdivision, compact, with the blend (of this line, whatever was changed since) in place of the line, or empty
/// where it does not fit. Its faces may have other corners than four.
std::optional<graph::Subdivision> with_shortcut(graph::Subdivision subdivision, const SpiralShortcut& shortcut,
                                                const Blend& blend);

}  // namespace quadrille::simplify
