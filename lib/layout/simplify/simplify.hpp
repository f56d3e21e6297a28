#pragma once
// Simplification of a conforming layout by collapse of chords (Viertel, Osting and Staten 2019, arXiv 1905.09097).
//
// Chords are tried by width over length, the thinnest first; one that can be collapsed (graph/chord_strip.hpp) is
// collapsed if no line deviates too far from the field and block quality stays acceptable. The number of blocks
// decreases at every step, so the loop ends. Chords whose ratios have a relative difference below 1e-6 are decided
// together: if two of them have a common rail, or one cannot be collapsed, none is, so that symmetric layouts stay
// symmetric. When no chord can be collapsed any more, spirals are shortened by the same rules
// (simplify/spiral_shortcut.hpp). A trial of a collapse is undone on the subdivision itself, at the cost of its
// changes, and strips far from a collapse are not looked at again (simplify/chord_groups.hpp); a trial of a shorter
// spiral changes a copy. None is built from scratch.

#include "base/report.hpp"
#include "field/evaluate.hpp"
#include "graph/candidate_layout.hpp"

namespace quadrille::simplify {

struct SimplifyOptions {
  double max_deviation = 0.44;  ///< radians: of a new line from the cross of the field
  /// Bounds of the blocks that a step changes; a bound that one of them exceeded before does not apply: corner angles
  /// (radians), and the scaled Jacobian of a block as one quad of order 8, whose Jacobian must be proved positive.
  double least_angle = 0.26, greatest_angle = 2.88;
  double least_scaled_jacobian = 0.3;
  /// The least scaled Jacobian of the changed blocks may decrease at most by the fraction of all blocks that the step
  /// removes.
  bool limits_loss_by_saving = true;
};

/// Returns a layout with as many blocks or fewer. Every face of `layout` must have four corners; the same holds for the
/// result. Reports blocks before, collapsed chords and the largest deviation, the latter two in the certificate as
/// well.
graph::CandidateLayout simplify(const field::FieldsOfRegions& fields, graph::CandidateLayout layout,
                                const SimplifyOptions& options, Report& report);

}  // namespace quadrille::simplify
