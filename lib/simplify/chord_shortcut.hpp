#pragma once
// Laps cut short. A separatrix that leaves P, passes a node Q side by side with the line that arrives there, and
// arrives at Q only after a lap, is replaced by a blend (simplify/chord_blend.hpp) from P to Q over that first stretch.
// What the lap cut in two is one block again; the lines that it crossed go on as they were. No chord could do that: the
// one beside such a line crosses itself.

#include <optional>
#include <vector>

#include "simplify/chord_collapse.hpp"

namespace quadrille::simplify {

/// Blocks of a strip between a pin at one side of a rung and the next at the other side, where both rails are the two
/// ends of one line between the pinned nodes.
struct Shortcut {
  int spline = 0;                            ///< of the line, in the graph's splines
  std::vector<HalfEdge> rungs, left, right;  ///< half-edges as in ChordStrip
  bool from_left = true;                     ///< P is the left end of the first rung
  double slimness = 0;                       ///< mean length of the rungs over that of the rails
};

/// All, in the sequence of their strips.
std::vector<Shortcut> find_shortcuts(const SeparatrixGraph& graph, const graph::PlanarFaces& faces,
                                     const std::vector<double>& lengths);

/// Nothing where it would turn too far.
std::optional<Blend> blend_of(const field::FieldEvaluator& evaluator, const SeparatrixGraph& graph,
                              const Shortcut& shortcut, const BlendOptions& options);

/// The graph with the blend (of this line, whatever was changed since) instead of the line, or nothing where it does
/// not fit. The caller takes the census.
std::optional<SeparatrixGraph> take_shortcut(const SeparatrixGraph& graph, const Shortcut& shortcut,
                                             const Blend& blend);

}  // namespace quadrille::simplify
