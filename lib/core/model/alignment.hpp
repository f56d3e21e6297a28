#pragma once
// Directions that the crosses of a field follow inside the domain (formats/alignment.md, lib/method.md §4).

#include <optional>
#include <vector>

#include "base/vec2.hpp"

namespace quadrille {

/// One Gaussian of the term mu v = f that is added to Laplace's equation, -Δv + mu v = f:
///
///   mu = sum_k rate_k g_k,    f = sum_k rate_k g_k e^(4 i angle_k),    g_k = exp(-|x - position_k|^2 / width_k^2).
///
/// |f| <= mu, so that |v| <= 1 as without the term.
struct AlignmentPoint {
  Vec2 position;
  double width = 0;  ///< a length, > 0
  double rate = 0;   ///< 1 / length^2, >= 0
  double angle = 0;  ///< of one direction of the cross, radians

  bool operator==(const AlignmentPoint&) const = default;
};

using Alignment = std::vector<AlignmentPoint>;

/// What a user prescribes: crosses have a direction at a point, along a curve or in a box.
struct AlignmentFeature {
  std::vector<Vec2> points;     ///< one, or those of a curve of straight pieces
  std::optional<double> angle;  ///< radians; none: that of the curve
  double width = 0;             ///< of the feature, a length, > 0; as given, 0: the usual one
  double strength = 1;          ///< >= 0
};

struct AlignmentBox {
  Vec2 low, high;
  double angle = 0;  ///< radians
  double width = 0;  ///< over which the directions of its surroundings become that of the box, a length, > 0
  double strength = 1;
};

/// Lengths that a solver asks for: `h1` along the direction `angle`, h2 across.
struct MetricSample {
  Vec2 position;
  double h1 = 0, h2 = 0;  ///< lengths, > 0
  double angle = 0;       ///< radians
};

struct AlignmentRequest {
  std::vector<AlignmentFeature> features;
  std::vector<AlignmentBox> boxes;
  std::vector<MetricSample> metric;
};

}  // namespace quadrille
