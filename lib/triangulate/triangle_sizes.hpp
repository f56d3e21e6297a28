#pragma once
// Prescribed element size at a position: min over the boundary segments of length + growth x distance, at most the
// global size. Curvature and gaps enter through the lengths of the boundary segments.

#include <vector>

#include "triangulate/boundary_segment.hpp"

namespace quadrille::triangulate {

/// The size field of a set of boundary segments.
class TriangleSizes {
 public:
  TriangleSizes(const std::vector<Segment>& segments, double size, double growth);
  /// The prescribed element size at x, a length. Cost: linear in the number of segments.
  double at(Vec2 x) const;

 private:
  struct Source {
    Vec2 position;
    double size = 0;
  };
  std::vector<Source> sources_;
  double size_, growth_;
};

}  // namespace quadrille::triangulate
