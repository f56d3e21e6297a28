#pragma once
// The number of layers that fit between each wall and the far side of the blocks along it (rules 10 to 13 of
// layer_rules).
//
// Layers fit when every sampled normal line has clearance for them - for the layers of both walls if the far side is
// one too - and neighbouring intervals above differ by no more than the greater of the growth and
// LayerConstants::greatest_change at the narrowest position: all lines of a chord have one number of intervals,
// determined by the widest position.

#include <array>
#include <vector>

#include "layers/end_spacing.hpp"

namespace quadrille::layers {

/// A line from a wall to the far side of its block, with its heights above the walls at sampled points.
struct NormalLineSample {
  int chord = 0;
  int front = -1, back = -1;          ///< specs of the walls at its beginning and its end; -1: none
  double size = 0;                    ///< prescribed beyond the layers
  std::vector<double> lengths;        ///< by sample: along the line from its beginning
  std::vector<double> front_heights;  ///< by sample: distance from the front wall
  std::vector<double> back_heights;   ///< by sample, counted from the end: distance from the back wall
  Vec2 far_end;
  std::array<int, 2> own_intervals{};  ///< WallSide::own_intervals of the front and the back wall
  /// Greatest over least scale of the chart at the samples: ratios of lengths in space and in the chart differ by less.
  double scale_range = 1;
};

/// By how much more than in space intervals may grow along the line in the chart, where the layers have blocks of their
/// own: there one interval is left above them, no longer than their growth allows. 1 elsewhere.
double chart_growth_factor(const WallSpec& spec, const NormalLineSample& line);

/// LayerConstants::lines_per_block lines across every block with walls, its sides among them; a block between two walls
/// is crossed once. `arc_sizes`: by arc, the prescribed interval.
std::vector<NormalLineSample> sample_normal_lines(const sizing::MeasuredLayout& measured, const WallSides& walls,
                                                  const std::vector<double>& arc_sizes);

/// The part of a line between its layers, given the layers' heights by spec; its length is negative if they have no
/// clearance.
FreePart part_between_layers(const NormalLineSample& line, const std::vector<std::vector<double>>& spec_heights);

/// The number of layers of each spec. Throws ComputeError with the greatest number that fits, and the position where
/// the prescribed ones do not. Positions in messages are those of the file of `face`.
/// `may_crowd`: crowding is ignored where all numbers are prescribed (rule 13): other intervals are made to suit.
std::vector<int> fitting_layers(const std::vector<WallSpec>& specs, const std::vector<NormalLineSample>& lines,
                                const CadFace& face, bool may_crowd = false);

}  // namespace quadrille::layers
