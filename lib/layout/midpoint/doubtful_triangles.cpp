#include "midpoint/doubtful_triangles.hpp"

#include <algorithm>

#include "curve/chain.hpp"
#include "mesh/transfinite.hpp"

namespace quadrille::midpoint {
namespace {

constexpr double least_share = 0.1;  ///< of the least Jacobian of the straight triangle's blocks

/// det J on [0, 1]^2 where a block of a straight triangle is smallest: at the centre.
double jacobian_at_centre(const TriMesh& mesh, int elem) {
  const auto& [a, b, c] = mesh.elem2vertices[elem];
  return cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]) / 12;
}

/// Whether the quadrilateral between a block's corners is convex; otherwise a side may have no length.
bool is_convex(const ArcGraph& graph, const std::array<HalfEdge, 4>& sides) {
  std::array<Vec2, 4> p;
  for (int k = 0; k < 4; ++k) p[k] = graph.nodes[start_of(graph.arcs, sides[k])].position;
  for (int k = 0; k < 4; ++k)
    if (!(cross(p[(k + 1) % 4] - p[k], p[(k + 2) % 4] - p[(k + 1) % 4]) > 0)) return false;
  return true;
}

}  // namespace

double jacobian_bound(const curve::CurveTable& table, const ArcGraph& graph, const std::array<HalfEdge, 4>& sides) {
  std::vector<curve::Chain> chains;
  for (const HalfEdge side : sides) chains.emplace_back(table, graph.arcs[side.arc].pieces);
  const mesh::TransfiniteMap map(
      {&chains[0], &chains[1], &chains[2], &chains[3]},
      {sides[0].is_backwards, sides[1].is_backwards, sides[2].is_backwards, sides[3].is_backwards});
  return 4 * mesh::block_shape(map).jacobian_bound;
}

std::vector<int> doubtful_triangles(const TriMesh& mesh, const DividedTriangles& divided) {
  const curve::CurveTable table(divided.graph.face, divided.graph.splines);
  std::vector<int> doubtful;
  for (const int elem : mesh.curved_elems) {
    const double least = least_share * jacobian_at_centre(mesh, elem);
    const auto is_doubtful = [&](const auto& sides) {
      return !is_convex(divided.graph, sides) || !(jacobian_bound(table, divided.graph, sides) > least);
    };
    if (std::any_of(divided.blocks[elem].begin(), divided.blocks[elem].end(), is_doubtful)) doubtful.push_back(elem);
  }
  return doubtful;
}

}  // namespace quadrille::midpoint
