#pragma once
// How many layers fit between each wall and the far side of the blocks along it, where the nearest irregular node lies.
//
// Lines across the blocks along the walls, their sides among them, are looked at: layers fit when on each line there is
// room for them (for those of both walls, where the far side is one too) and the intervals above, of which all lines of
// the chord have as many as the widest place needs, still change by no more than the greater of `growth` and 1.25 from
// one to the next in the narrowest place.

#include <vector>

#include "layers/chord_layers.hpp"
#include "layers/wall_sides.hpp"
#include "sizing/measured_layout.hpp"

namespace quadrille::layers {

/// A line from a wall to the far side of its block, with its height above the walls at sampled places.
struct ColumnProbe {
  int chord = 0;
  int front = -1, back = -1;                                 ///< specs; the line begins at the front wall
  double size = 0;                                           ///< wanted beyond the layers
  std::vector<double> lengths, front_heights, back_heights;  ///< by sample; from the beginning
  Vec2 far_end;
};

std::vector<ColumnProbe> probe_columns(const sizing::MeasuredLayout& measured, const WallSides& walls,
                                       const std::vector<double>& arc_sizes);

/// The number of layers of each spec. Throws ComputeError with the largest numbers that fit and the place where those
/// asked for do not.
std::vector<int> fitting_layers(const std::vector<WallSpec>& specs, const std::vector<ColumnProbe>& probes,
                                Vec2 origin);

/// What lies between the layers of a probe; the length is negative where they have no room.
InnerLine rest_of_probe(const ColumnProbe& probe, const std::vector<std::vector<double>>& spec_heights);

/// The greatest growth beyond the layers: nearly even ones must still be able to reach the wanted size.
double growth_beyond(const WallSpec& spec);

}  // namespace quadrille::layers
