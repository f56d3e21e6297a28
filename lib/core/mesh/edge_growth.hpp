#pragma once
// The ratio of adjacent edges along the lines of a quad mesh.

#include "model/quad_mesh.hpp"

namespace quadrille::mesh {

struct EdgeGrowth {
  double greatest = 1;  ///< longer over shorter, of edges that continue each other across an edge of both elements
  Vec2 position;        ///< of their common vertex, relative to the face's origin
  double excess = 0;    ///< sum of ln^2 (ratio / limit) over the ratios above it, on both sides of each line
};

/// Of all lines; lengths are distances of vertices. Of equal ratios (within 1e-6) that of the first element. `limit`:
/// of the excess, at least 1.
EdgeGrowth edge_growth(const QuadMesh& mesh, double limit = 1);

}  // namespace quadrille::mesh
