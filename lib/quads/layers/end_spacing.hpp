#pragma once
// The spacing prescribed at the ends of arcs (layers, or the first interval that continues a neighbour's), and the
// resulting division of one arc.

#include <array>
#include <vector>

#include "mesh/chords.hpp"
#include "sizing/graded_intervals.hpp"

namespace quadrille::layers {

/// The spacing prescribed at one end of an arc; none by default.
struct EndSpacing {
  std::vector<double> layer_ends;  ///< upper ends of the layers, as rising fractions of the arc's length from this end
  double before = 0;               ///< length next to the first free interval: the last layer or a neighbour's; 0: none
  double growth = 0;               ///< greatest ratio of an interval to the one before it

  bool is_free() const { return before <= 0; }
  int layers() const { return static_cast<int>(layer_ends.size()); }
};

/// Both ends of an arc (0: from, 1: to).
using ArcSpacing = std::array<EndSpacing, 2>;

/// The part of an arc, or of a line across a block, between the layers at both ends; all of it if there are none.
struct FreePart {
  sizing::GradedEnds ends;
  double length = 0;  ///< negative if the layers overlap
  double size = 0;    ///< prescribed there
  int layers = 0;     ///< at both ends together
};

FreePart free_part(const ArcSpacing& spacing, double length, double size);

/// The least growth prescribed on the chord; 0 if nothing is. `spacings`: by arc.
double least_growth(const mesh::Chord& chord, const std::vector<ArcSpacing>& spacings);

/// The ends of `count` intervals as fractions of the arc's length: the layers' as prescribed, between them intervals
/// that grow from both ends towards `size` (sizing/graded_intervals).
std::vector<double> spaced_ends(const ArcSpacing& spacing, double length, double size, int count);

/// The least size, no less than `size`, with which spaced_ends fills the arc by `count` intervals that grow by at most
/// `growth`. If every size needs more growth, one so great that all free intervals grow by one ratio.
double even_size(const ArcSpacing& spacing, double length, double size, double growth, int count);

}  // namespace quadrille::layers
