#pragma once
// The prescribed interval on each arc.

#include <vector>

#include "layers/wall_input.hpp"

namespace quadrille::layers {

struct ArcSizes {
  std::vector<double> prescribed;  ///< by arc: harmonic mean of the size field
  std::vector<double> scale;       ///< by arc: factor by which the geometric tolerance shortens it; 1 at first

  double at(int arc) const { return prescribed[arc] * scale[arc]; }
};

ArcSizes arc_sizes(const WallInput& input);

}  // namespace quadrille::layers
