#pragma once
// Quality measures of the blocks of a layout, by which changes are accepted or rejected.

#include <set>
#include <vector>

#include "graph/subdivision.hpp"

namespace quadrille::simplify {

/// The worst values over a set of blocks.
struct BlockQuality {
  double least_angle = 4, greatest_angle = 0;  ///< at corners, radians
  double least_scaled_jacobian = 1;            ///< of blocks as quads of order 8 (mesh/block_shape.hpp)
  bool is_valid = true;                        ///< all Jacobians are proved positive
};

/// The quality of these faces, each of which must have four sides.
BlockQuality worst_quality(const graph::Subdivision& subdivision, const std::vector<int>& faces);

/// The quality of all faces.
BlockQuality worst_quality(const graph::Subdivision& subdivision);

/// Faces with a side among these arcs, ascending.
std::vector<int> faces_beside(const graph::Subdivision& subdivision, const std::set<int>& arcs);

}  // namespace quadrille::simplify
