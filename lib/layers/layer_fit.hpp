#pragma once
// How many layers fit between each wall and the far side of the blocks along it (rules 10 to 13 of layer_rules).
//
// Layers fit when every sampled normal line has clearance for them - for those of both walls, where the far side is one
// too - and the intervals above change from one to the next by no more than the greater of the growth and
// LayerConstants::greatest_change in the narrowest place: all lines of a chord have one number of intervals, that which
// the widest place needs.

#include <vector>

#include "layers/normal_line_samples.hpp"
#include "layers/wall_spec.hpp"

namespace quadrille::layers {

/// The number of layers of each spec. Throws ComputeError with the greatest number that fits, and the place where the
/// prescribed ones do not. Places in messages are relative to the file: `origin` is added to them.
std::vector<int> fitting_layers(const std::vector<WallSpec>& specs, const std::vector<NormalLineSample>& lines,
                                Vec2 origin);

/// The greatest growth beyond the layers of a wall.
double growth_beyond(const WallSpec& spec);

}  // namespace quadrille::layers
