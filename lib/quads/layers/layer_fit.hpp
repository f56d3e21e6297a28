#pragma once
// The number of layers that fit between each wall and the far side of the blocks along it (rules 10 to 13 of
// layer_rules).
//
// Layers fit when every sampled normal line has clearance for them - for the layers of both walls if the far side is
// one too - and neighbouring intervals above differ by no more than the greater of the growth and
// LayerConstants::greatest_change at the narrowest position: all lines of a chord have one number of intervals,
// determined by the widest position.

#include <vector>

#include "layers/normal_line_samples.hpp"
#include "layers/wall_spec.hpp"

namespace quadrille::layers {

/// The number of layers of each spec. Throws ComputeError with the greatest number that fits, and the position where
/// the prescribed ones do not. Positions in messages are in file coordinates: `origin` is added.
/// `may_crowd`: crowding is ignored where all numbers are prescribed (rule 13): other intervals are made to suit.
std::vector<int> fitting_layers(const std::vector<WallSpec>& specs, const std::vector<NormalLineSample>& lines,
                                Vec2 origin, bool may_crowd = false);

/// The greatest growth beyond the layers of a wall.
double growth_beyond(const WallSpec& spec);

}  // namespace quadrille::layers
