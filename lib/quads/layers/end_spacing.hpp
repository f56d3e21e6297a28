#pragma once
// The spacing prescribed at the ends of arcs (layers, or the first interval that continues a neighbour's), and the
// resulting division of one arc.

#include <array>
#include <vector>

#include "layers/wall_sides.hpp"
#include "sizing/grade_chords.hpp"

namespace quadrille::layers {

/// The input of the planning of wall layers.
struct WallInput {
  const sizing::MeasuredLayout& measured;
  const std::vector<WallSpec>& specs;
  const sizing::SizeField& sizes;
  int order = 4;
  double tolerance = 0;    ///< as in refine/DivideOptions
  bool may_crowd = false;  ///< intervals above the layers will be made to suit them (growth/limit_growth)
  std::vector<sizing::ChordCount> counts = {};  ///< prescribed, layers included; of several for one chord the last

  /// 0: none.
  int prescribed_count(int chord) const {
    int count = 0;
    for (const sizing::ChordCount& one : counts)
      if (one.chord == chord) count = one.count;
    return count;
  }
  const BlockLayout& blocks() const { return measured.blocks(); }
};

/// The prescribed interval on each arc.
struct ArcSizes {
  std::vector<double> prescribed;  ///< by arc: harmonic mean of the size field
  std::vector<double> scale;       ///< by arc: factor by which the geometric tolerance shortens it; 1 at first

  double at(int arc) const { return prescribed[arc] * scale[arc]; }
};

ArcSizes arc_sizes(const WallInput& input);

/// The intervals on both sides of the length to be divided; 0: none, the end is free.
struct GradedEnds {
  double before = 0, after = 0;
  bool are_free() const { return before <= 0 && after <= 0; }
};

/// `count` lengths that sum to `length`. From one end, after i steps, the length is
///   F_i = cap h q^i / (cap + h (q^i - 1)),
/// h the neighbour there: growth by q at most, saturating at `cap`. Between two neighbours, with x = i / (count + 1),
/// F_i^(1-x) B_i^x, B the same from the other end. q follows from the sum and may be below 1; the result depends
/// smoothly on all arguments. Equal lengths between free ends.
std::vector<double> graded_intervals(const GradedEnds& ends, int count, double length, double cap);

/// Greatest ratio of two neighbouring intervals, the given ones included, larger over smaller: at least 1.
double worst_growth(const GradedEnds& ends, const std::vector<double>& intervals);
/// The least count for which no interval exceeds `cap` and none is more than `growth` times its neighbour. At most
/// `most`.
int least_graded_count(const GradedEnds& ends, double length, double cap, double growth, int most);

/// The spacing prescribed at one end of an arc; none by default.
struct EndSpacing {
  std::vector<double> layer_ends;  ///< upper ends of the layers, as rising fractions of the arc's length from this end
  double before = 0;               ///< length next to the first free interval: the last layer or a neighbour's; 0: none
  double growth = 0;               ///< greatest ratio of an interval to the one before it

  bool is_free() const { return before <= 0; }
  int layers() const { return static_cast<int>(layer_ends.size()); }
  /// The fraction of the arc that the last layer takes; there is one.
  double last_layer() const { return layer_ends.back() - (layers() > 1 ? layer_ends[layers() - 2] : 0); }
};

/// Both ends of an arc (0: from, 1: to).
using ArcSpacing = std::array<EndSpacing, 2>;

/// The part of an arc, or of a line across a block, between the layers at both ends; all of it if there are none.
struct FreePart {
  GradedEnds ends;
  double length = 0;  ///< negative if the layers overlap
  double size = 0;    ///< prescribed there
  int layers = 0;     ///< at both ends together
};

FreePart free_part(const ArcSpacing& spacing, double length, double size);

/// The least growth prescribed on the chord; 0 if nothing is. `spacings`: by arc.
double least_growth(const mesh::Chord& chord, const std::vector<ArcSpacing>& spacings);

/// The ends of `count` intervals as fractions of the arc's length: the layers' as prescribed, between them intervals
/// that grow from both ends towards `size` (graded_intervals).
std::vector<double> spaced_ends(const ArcSpacing& spacing, double length, double size, int count);

/// The least size, no less than `size`, with which spaced_ends fills the arc by `count` intervals that grow by at most
/// `growth`. If every size needs more growth, one so great that all free intervals grow by one ratio.
double even_size(const ArcSpacing& spacing, double length, double size, double growth, int count);

/// The spacings that the layers of the walls prescribe on the arcs that start there.
struct LayerRequests {
  std::vector<ArcSpacing> spacings;  ///< by arc
  /// By arc and end: fractions of the arc's length, from this end, at which its nodes in the layers lie.
  std::vector<std::array<std::vector<double>, 2>> nodes;
};

/// `spec_heights`: by spec, upper ends of its layers. Throws ComputeError with the position if an arc turns back to the
/// wall before the layers end.
LayerRequests request_layers(const WallInput& input, const WallSides& walls,
                             const std::vector<std::vector<double>>& spec_heights);

/// The fractions of all nodes of the arcs that start at walls: in the layers at their heights, elsewhere
/// Gauss-Lobatto-Legendre points of each interval. Empty for other arcs, and for those on which the end of a layer
/// moved onto a break (rule 17): all their nodes follow from the intervals.
std::vector<std::vector<double>> layered_arc_nodes(const LayerRequests& requests, const sizing::ArcDivisions& divisions,
                                                   int order);

}  // namespace quadrille::layers
