#pragma once
// How good the blocks of a layout are, to decide whether a change is worth it.

#include <vector>

#include "graph/subdivision.hpp"

namespace quadrille::simplify {

/// The worst of some blocks.
struct BlockQuality {
  double least_angle = 4, greatest_angle = 0;  ///< at corners, radians
  double least_scaled_jacobian = 1;            ///< of blocks taken as quads of order 8 (mesh/block_shape.hpp)
  bool is_valid = true;                        ///< all Jacobians are proved positive
};

/// Of these faces, each of four sides.
BlockQuality worst_quality(const graph::Subdivision& subdivision, const std::vector<int>& faces);

/// Of all faces.
BlockQuality worst_quality(const graph::Subdivision& subdivision);

/// Faces with a side among the marked arcs, ascending.
std::vector<int> faces_beside(const graph::Subdivision& subdivision, const std::vector<bool>& is_marked);

}  // namespace quadrille::simplify
