#pragma once
// A metric as users give it (formats/alignment.md, "As a table"): of a planar face in the plane, of a curved one in
// space.

#include <array>
#include <vector>

#include "base/vec3.hpp"
#include "model/alignment.hpp"

namespace quadrille {

struct SpaceMetricSample {
  Vec3 position;                   ///< in the coordinates of the CAD file
  std::array<double, 6> tensor{};  ///< m11, m12, m13, m22, m23, m33: lengths are 1 / sqrt of its eigenvalues

  /// a M b.
  double product(Vec3 a, Vec3 b) const {
    const auto& [m11, m12, m13, m22, m23, m33] = tensor;
    return dot(a, Vec3{m11 * b.x + m12 * b.y + m13 * b.z, m12 * b.x + m22 * b.y + m23 * b.z,
                       m13 * b.x + m23 * b.y + m33 * b.z});
  }
};

/// Of a table in space both: its positions and tensors without z are those in the plane.
struct GivenMetric {
  std::vector<MetricSample> in_plane;
  std::vector<SpaceMetricSample> in_space;
};

struct GivenAlignment : AlignmentRequest {
  std::vector<SpaceMetricSample> metric_in_space;
};

}  // namespace quadrille
