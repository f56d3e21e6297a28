#pragma once
// Simplification of a conforming layout by collapse of chords (Viertel, Osting and Staten 2019, arXiv 1905.09097).
//
// Chords are tried by width over length, the thinnest first; one that can be collapsed (graph/chord_strip.hpp) is,
// where that turns no line too far from the field and leaves its blocks in good shape. The count of blocks falls at
// every step, so it ends. Chords whose ratios differ by less than 1e-6 of themselves are decided together: where two of
// them share a rail, or one cannot be collapsed, none is, so that symmetric layouts stay symmetric.
// Where no chord is left, laps are cut short by the same rules (simplify/chord_shortcut.hpp).

#include "base/report.hpp"
#include "field/evaluate.hpp"
#include "model/separatrix_graph.hpp"

namespace quadrille::simplify {

struct SimplifyOptions {
  double max_turn = 0.44;  ///< radians: of a new line from the cross of the field
  /// Bounds of the blocks that a collapse touches, each unless one of them was beyond it before: corner angles
  /// (radians), and the scaled Jacobian of a block as one quad of order 8, whose Jacobian must be proved positive.
  double least_angle = 0.26, greatest_angle = 2.88;
  double least_scaled_jacobian = 0.3;
  /// No step may take a greater share of the least scaled Jacobian of the blocks it touches than it saves of all
  /// blocks.
  bool is_thrifty = true;
};

/// A layout with as many blocks or fewer. Every face of `graph` must have four corners; the same holds for the result.
/// Reports blocks before, collapsed chords and the largest turn, the latter two to the graph's certificate as well.
SeparatrixGraph simplify(const field::FieldEvaluator& evaluator, SeparatrixGraph graph, const SimplifyOptions& options,
                         Report& report);

}  // namespace quadrille::simplify
