#pragma once
// Normal lines across blocks, as sampled, for the tests of how many layers fit.

#include <string>
#include <vector>

#include "layers/layer_fit.hpp"
#include "wall_samples.hpp"

namespace quadrille::wall_samples {

/// A straight line at right angles to its walls.
inline layers::NormalLineSample straight(int chord, double length, int front, int back = -1, double size = 0.1) {
  layers::NormalLineSample line{chord, front, back, size, {}, {}, {}, {1, 2}, {}};
  for (int i = 0; i <= 64; ++i) line.lengths.push_back(length * i / 64);
  line.front_heights = line.lengths;
  if (back >= 0) line.back_heights = line.lengths;
  return line;
}

/// The number of layers of one wall.
inline int fitting(const std::string& wall, const std::vector<layers::NormalLineSample>& lines) {
  return layers::fitting_layers(parse({wall}), lines, CadFace()).front();
}

}  // namespace quadrille::wall_samples
