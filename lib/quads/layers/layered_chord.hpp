#pragma once
// A chord with the spacings prescribed at the ends of its arcs, in the chord's own direction.

#include <array>
#include <vector>

#include "layers/arc_sizes.hpp"
#include "layers/end_spacing.hpp"
#include "layers/wall_input.hpp"

namespace quadrille::layers {

/// Two arcs of a chord on opposite sides of a block, by their positions in the chord.
struct OppositeArcs {
  int a = 0, b = 0;
  double distance = 0;  ///< mean length of the sides that lead from one to the other
};

/// Arcs are named by their position i in the chord; ends by the chord's direction (0: beginning, 1: end). The objects
/// it refers to must outlive it.
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

}  // namespace quadrille::layers
