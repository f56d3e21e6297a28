#pragma once
// The ends of the intervals on the arcs of one chord that has layers at its ends, or that continues intervals finer
// than the prescribed size (rules 14 to 16 and 23 of layer_rules).
//
// All arcs have one count. An arc that starts at a wall has the layers at that end, then intervals that grow by at most
// the chord's growth up to the prescribed size (end_spacing). An arc beyond the end of the wall starts with the same
// first interval, but returns to its own division as fast as LayerConstants::greatest_slope allows over the distance
// from the wall's end: constant heights would result in needles throughout the domain, and an immediately free division
// would skew the elements beside the wall.
//
// The difference between the divisions of opposite arcs is then reduced, so that lines are nearly normal to the arcs
// across narrow blocks while they change from one division to the other across wide ones. Above the layers the
// divisions u of all arcs (in the chord's parameter, scaled to 0 and 1 where the layers end) solve
//
//   (u_a - own_a) + sum over opposite arcs b with as many layers at both ends  w_ab (u_a - u_b) = 0,
//
//   w_ab = (mean length of a and b / (2 distance))^4,
//
// with twice the distance if there are layers, unless refine/align_chords found equal fractions to skew the chord. The
// matrix is an M-matrix with row sums 1: every u is a weighted mean of the arcs' own divisions, and rises as they do.

#include <array>
#include <vector>

#include "layers/end_spacing.hpp"

namespace quadrille::layers {

/// Two arcs of a chord on opposite sides of a block, by their positions in the chord.
struct OppositeArcs {
  int a = 0, b = 0;
  double distance = 0;  ///< mean length of the sides that lead from one to the other
};

/// A chord with the spacings prescribed at the ends of its arcs. Arcs are named by their position i in the chord; ends
/// by the chord's direction (0: beginning, 1: end). The objects it refers to must outlive it.
class LayeredChord {
 public:
  /// `spacings`: by arc. The sizes are copied.
  LayeredChord(const WallInput& input, int chord, const std::vector<ArcSpacing>& spacings, const ArcSizes& sizes);

  int num_arcs() const { return static_cast<int>(chord_.arcs.size()); }
  double length(int i) const { return input_.measured.length(arc(i)); }
  double size(int i) const { return sizes_[i]; }
  double growth() const { return growth_; }  ///< least_growth
  /// The spacing prescribed on arc i, by the arc's own ends.
  const ArcSpacing& spacing(int i) const { return spacings_[arc(i)]; }
  /// The spacing prescribed at the chord's beginning or end.
  const EndSpacing& at_end(int i, int chord_end) const { return spacing(i)[own_end(i, chord_end)]; }
  int own_end(int i, int chord_end) const { return chord_.backwards[i] ? 1 - chord_end : chord_end; }
  /// Step k of `count` steps along the chord, counted along arc i.
  int own_step(int i, int k, int count) const { return chord_.backwards[i] ? count - 1 - k : k; }

  /// Between a fraction of the arc's own length and the chord's parameter.
  double parameter(int i, double fraction) const { return input_.measured.chord_parameter(chord_, i, fraction); }
  double fraction(int i, double parameter) const { return input_.measured.arc_fraction(chord_, i, parameter); }
  /// Whether refine/align_chords found equal fractions to skew the chord on this arc.
  bool is_aligned(int i) const { return !input_.measured.parameter(arc(i)).is_identity(); }

  /// Ordered by block; a block that touches itself is omitted.
  const std::vector<OppositeArcs>& opposite_arcs() const { return opposite_arcs_; }

 private:
  int arc(int i) const { return chord_.arcs[i]; }

  const WallInput& input_;
  const mesh::Chord& chord_;
  const std::vector<ArcSpacing>& spacings_;
  std::vector<double> sizes_;  ///< by position
  double growth_ = 0;
  std::vector<OppositeArcs> opposite_arcs_;
};

/// Aligns divisions, by position in the chord; layers are not moved.
void align_divisions(const LayeredChord& chord, std::vector<sizing::ArcDivision>& divisions);

/// One division for each arc of the chord, by position. `lines`: more lines that the count must suit.
/// `prescribed_count`: the count whatever arcs and lines need, if no arc has as many layers; 0: none.
std::vector<sizing::ArcDivision> layered_divisions(const LayeredChord& chord, const std::vector<FreePart>& lines,
                                                   int least_count, int prescribed_count = 0);

}  // namespace quadrille::layers
