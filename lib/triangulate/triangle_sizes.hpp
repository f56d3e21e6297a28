#pragma once
// Prescribed element size at a position: min over the boundary segments of length + growth x distance, at most the
// global size. Curvature and gaps enter through the lengths of the boundary segments.

#include <vector>

#include "triangulate/boundary_segment.hpp"

namespace quadrille::triangulate {

class TriangleSizes {
 public:
  TriangleSizes(const std::vector<Segment>& segments, double size, double growth);
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
