#pragma once
// Where the intervals end on the arcs of one chord that has layers at its ends, or goes on from intervals that are
// finer than the wanted size.
//
// All arcs share one count. An arc that leaves a wall has the layers' cuts at that end, then intervals that grow on by
// at most `growth` up to the wanted size (sizing/graded_intervals). An arc beyond the end of the wall starts with the
// same first interval, but goes over to its own free division as far as that turns no line by more than 0.2 over the
// way from the wall's end: kept heights would leave needles all the way through the domain, and a division that is free
// at once would skew the elements beside the wall.
//
// Above the layers the divisions u of all arcs (in the parameters of refine/align_chords, 0 and 1 where the layers end)
// are then drawn together, by
//
//   (u_a - wanted_a) + sum over neighbours b with the same layers (length / (2 distance))^4 (u_a - u_b) = 0,
//
// with twice the distance where there are layers, unless refine/align_chords found equal fractions to skew the chord,
// so that lines stay upright across narrow blocks while wide ones go over from one division to the other. The solution
// is a mean of the wanted divisions: it rises as they do.

#include <array>
#include <vector>

#include "sizing/arc_division.hpp"
#include "sizing/graded_intervals.hpp"
#include "sizing/measured_layout.hpp"

namespace quadrille::layers {

/// What one end of an arc asks for; nothing by default.
struct ArcEndWish {
  std::vector<double> cuts;  ///< upper ends of the layers, as rising shares of the arc's length from this end
  double before = 0;  ///< length of the interval below the first free one: the last layer or a neighbour; 0: none
  double growth = 0;  ///< greatest from one interval to the next

  bool is_empty() const { return before <= 0; }
  int layers() const { return static_cast<int>(cuts.size()); }
};

/// By arc and end (0: from, 1: to).
using ArcWishes = std::vector<std::array<ArcEndWish, 2>>;

/// A line across a block of the chord, as long as `length` between its layers.
struct InnerLine {
  sizing::GradedEnds ends;
  double length = 0;
  double size = 0;  ///< wanted there
  int layers = 0;   ///< at both ends together
};

/// The rest of an arc between its layers.
InnerLine rest_of_arc(const std::array<ArcEndWish, 2>& wishes, double length, double size);

struct ChordLayersInput {
  const sizing::MeasuredLayout& measured;
  const mesh::Chord& chord;
  const ArcWishes& wishes;               ///< of all arcs
  const std::vector<double>& arc_sizes;  ///< wanted interval on each arc
  std::vector<InnerLine> lines;          ///< more lines that the count must suit
  int least_count = 1;
};

/// The division of each arc of the chord.
std::vector<sizing::ArcDivision> layered_divisions(const ChordLayersInput& input);

/// The least growth that a wish of the chord names; 0 without any.
double chord_growth(const mesh::Chord& chord, const ArcWishes& wishes);

}  // namespace quadrille::layers
