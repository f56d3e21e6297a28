#pragma once
// A function along a chain of curves with a limited slope, and without kinks.

#include <vector>

#include "base/vec2.hpp"

namespace quadrille::offset {

/// The distance that is allowed at places along a chain, over the prescribed one.
struct RatioSamples {
  bool is_closed = false;
  std::vector<double> lengths;  ///< along the chain, ascending; of a closed one the last is its start again
  std::vector<double> ratios;   ///< in (0, 1]
  std::vector<Vec2> positions;  ///< on the wall
  std::vector<int> first;       ///< curve i has the samples first[i] to first[i + 1]
  double distance = 1;          ///< the least prescribed one
};

struct SmoothRatios {
  std::vector<double> ratios, slopes;  ///< one for each sample; slopes by length
};

/// The least of the ratios within a distance around each sample, then the greatest function below that whose product
/// with `distance` has at most the slope greatest_slope, averaged twice over a distance: nowhere above the ratios.
SmoothRatios smoothed_ratios(const RatioSamples& samples);

}  // namespace quadrille::offset
