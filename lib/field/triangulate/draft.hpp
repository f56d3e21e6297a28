#pragma once
// A triangle mesh under construction: straight elements, and boundary edges as directed pairs of vertices.

#include <array>
#include <vector>

#include "base/vec2.hpp"

namespace quadrille::triangulate {

/// From vertex `from` to vertex `to` along `curve`, t0 < t1, the face on the left.
struct DraftEdge {
  int from = 0, to = 0;
  int curve = 0;
  double t0 = 0, t1 = 0;
};

struct Draft {
  std::vector<Vec2> vertices;
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> layers;  ///< one per triangle: -1, or the layer of its fan
  std::vector<DraftEdge> edges;

  int add_vertex(Vec2 position) {
    vertices.push_back(position);
    return static_cast<int>(vertices.size()) - 1;
  }
  void add_triangle(int a, int b, int c, int layer) {
    triangles.push_back({a, b, c});
    layers.push_back(layer);
  }
};

}  // namespace quadrille::triangulate
