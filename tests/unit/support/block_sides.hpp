#pragma once
// Sides of blocks from the integers of the file format, for layouts made by hand.

#include <array>

#include "model/arc_graph.hpp"

namespace quadrille {

/// a: arc a forwards, -1 - a: arc a backwards.
inline std::array<HalfEdge, 4> block_sides(const std::array<int, 4>& codes) {
  std::array<HalfEdge, 4> sides;
  for (int k = 0; k < 4; ++k) sides[k] = half_edge_of_code(codes[k]);
  return sides;
}

}  // namespace quadrille
