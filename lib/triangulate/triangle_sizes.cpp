#include "triangulate/triangle_sizes.hpp"

#include <algorithm>

namespace quadrille::triangulate {

TriangleSizes::TriangleSizes(const std::vector<Segment>& segments, double size, double growth)
    : size_(size), growth_(growth) {
  sources_.reserve(3 * segments.size());
  for (const Segment& segment : segments)
    for (const int k : {0, 2, 4}) sources_.push_back({segment.samples[k], segment.length()});
}

double TriangleSizes::at(Vec2 x) const {
  double least = size_;
  for (const Source& source : sources_) {
    // Only sources that can still attain the minimum need a square root.
    const double reach = (least - source.size) / growth_;
    if (reach > 0 && norm2(x - source.position) < reach * reach)
      least = std::min(least, source.size + growth_ * norm(x - source.position));
  }
  return least;
}

}  // namespace quadrille::triangulate
