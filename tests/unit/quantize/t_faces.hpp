#pragma once
// Faces of T-meshes from the integers of the file format, for tests of this folder.

#include <array>
#include <vector>

#include "model/arc_graph.hpp"
#include "quantize/quantize.hpp"

namespace quadrille::quantize {

/// A face from its sides, each a list of arcs as files hold them: -1 - a is arc a backwards.
inline TFace face(const std::array<std::vector<int>, 4>& sides) {
  TFace result;
  for (int k = 0; k < 4; ++k)
    for (const int code : sides[k]) result[k].push_back(half_edge_of_code(code));
  return result;
}

/// The length of a side, by the lengths of arcs.
inline int sum(const std::vector<HalfEdge>& side, const std::vector<int>& lengths) {
  int total = 0;
  for (const HalfEdge h : side) total += lengths[h.arc];
  return total;
}

}  // namespace quadrille::quantize
