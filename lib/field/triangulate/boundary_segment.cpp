#include "triangulate/boundary_segment.hpp"

#include <algorithm>
#include <limits>

#include "base/segments.hpp"

namespace quadrille::triangulate {

double segment_distance(const Segment& a, const Segment& b) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      least = std::min(least, distance_of_segments(a.samples[i], a.samples[i + 1], b.samples[j], b.samples[j + 1]));
  return least;
}

}  // namespace quadrille::triangulate
