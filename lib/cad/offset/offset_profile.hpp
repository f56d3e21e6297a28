#pragma once
// The distance of an offset curve from its wall, and its limited slope along a chain of walls.

#include <vector>

#include "base/vec2.hpp"
#include "model/cad_face.hpp"
#include "offset/chart_heights.hpp"
#include "offset/wall_chains.hpp"

namespace quadrille::offset {

/// The distance that is allowed at places along a chain, over the prescribed one.
struct RatioSamples {
  bool is_closed = false;
  std::vector<double> lengths;  ///< along the chain, ascending; of a closed one the last is its start again
  std::vector<double> ratios;   ///< in (0, 1]
  std::vector<Vec2> positions;  ///< on the wall
  std::vector<int> first;       ///< curve i has the samples first[i] to first[i + 1]
  double distance = 1;          ///< the least prescribed one, on a curved face about its length in the chart
};

struct SmoothRatios {
  std::vector<double> ratios, slopes;  ///< one for each sample; slopes by length
};

/// The least of the ratios within a distance around each sample, then the greatest function below that whose product
/// with `distance` has at most the slope greatest_slope, averaged twice over a distance: nowhere above the ratios.
SmoothRatios smoothed_ratios(const RatioSamples& samples);

// The distance of an offset curve from its wall: the prescribed one, or less where a facing wall or a strong bend
// leaves less room.
//
// At a point p of the wall with the normal n into the face, the circle that touches the wall in p and passes through
// another point b of the boundary has the radius |b - p|^2 / (2 n.(b - p)). The least of these radii is the distance at
// which offset curves of both places would meet. A share of it is allowed; the distance then changes along the wall
// with a limited slope, and smoothly. Curves that meet the wall in a corner below 180 degrees do not count: there the
// offset curves are cut at their crossing.

// On a curved face all this is so in its chart; prescribed distances, and those of profiles, are lengths in space.

/// The distance along one curve of a chain.
struct OffsetProfile {
  double distance = 0;      ///< the prescribed one
  bool is_constant = true;  ///< it is the prescribed one everywhere
  /// Else: (distance, 0) by the arc length of the curve, a cubic spline.
  Nurbs by_length;

  double at(double length) const;
  double slope(double length) const;
};

struct ChainProfile {
  std::vector<OffsetProfile> curves;  ///< one for each curve of the chain
  double least_ratio = 1;             ///< of the distance and the prescribed one
  Vec2 narrowest;                     ///< the place on the wall where it is least
};

/// `wall_distance`: by curve of the face, its prescribed distance; 0: no wall. Cost: the square of the number of
/// samples of the region.
ChainProfile chain_profile(const CadFace& face, const WallChain& chain, const std::vector<double>& wall_distance,
                           const ChartHeights& heights);

}  // namespace quadrille::offset
