#pragma once
// The size that elements should have at a place: min over the boundary segments of length + growth x distance, at most
// the global size. The boundary carries curvature and gaps in the lengths of its segments.

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
