#pragma once
// A triangle mesh under construction: straight elements, and boundary edges as directed pairs of vertices. Its last
// steps: smoothing, cutting along slits, and an order by regions.

#include <array>
#include <vector>

#include "base/vec2.hpp"
#include "model/tri_mesh.hpp"

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

/// Doubles the vertices on slits, so that the elements on both sides of a slit are not neighbours: gives each vertex
/// where boundary edges meet one copy for each sector between them. A sector without a copy keeps the vertex itself; at
/// the tip of a slit there is one sector. Copies are added at the end of draft.vertices, in the order of their
/// vertices. Returns the vertex from which each vertex was copied, itself for the others.
std::vector<int> cut_slits(Draft& draft);

/// Shape of a triangle: 4 sqrt(3) area / (sum of squared edges); 1 equilateral, 0 degenerate, negative inverted.
double triangle_shape(Vec2 a, Vec2 b, Vec2 c);

/// Moves the vertices with `is_free` towards the mean of their neighbours, each only if this improves the least shape
/// around it; the connectivity does not change. `is_free` has one entry per vertex.
void smooth(Draft& draft, const std::vector<char>& is_free);

/// Sorts elements, and vertices, by region, and sets mesh.region_elems. Regions must share no vertex. Returns the
/// former number of each vertex. A mesh of one region keeps its order.
std::vector<int> sort_by_region(TriMesh& mesh);

}  // namespace quadrille::triangulate
