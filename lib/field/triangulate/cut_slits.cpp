#include "triangulate/cut_slits.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "base/disjoint_sets.hpp"

namespace quadrille::triangulate {
namespace {

using Edge = std::pair<int, int>;

bool has_slits(const Draft& draft) {
  std::set<Edge> edges;
  for (const DraftEdge& edge : draft.edges) edges.insert({edge.from, edge.to});
  return std::any_of(draft.edges.begin(), draft.edges.end(), [&](const DraftEdge& edge) {
    return edges.contains({edge.to, edge.from});
  });
}

/// The corners of triangles (corner k of triangle t is 3 t + k) that lie in one sector of their vertex.
DisjointSets sectors_of(const Draft& draft) {
  std::set<Edge> closed;
  for (const DraftEdge& edge : draft.edges) closed.insert({edge.from, edge.to});
  std::map<Edge, int> edge2corner;  ///< to the corner at which the edge of a triangle starts
  DisjointSets sectors(3 * draft.triangles.size());
  const int count = static_cast<int>(draft.triangles.size());
  for (int t = 0; t < count; ++t) {
    for (int k = 0; k < 3; ++k) {
      const int from = draft.triangles[t][k], to = draft.triangles[t][(k + 1) % 3];
      if (closed.contains({from, to})) continue;
      edge2corner[{from, to}] = 3 * t + k;
      const auto across = edge2corner.find({to, from});
      if (across == edge2corner.end()) continue;
      const int other = across->second;
      sectors.unite(3 * t + k, other - other % 3 + (other + 1) % 3);
      sectors.unite(3 * t + (k + 1) % 3, other);
    }
  }
  return sectors;
}

}  // namespace

std::vector<int> cut_slits(Draft& draft) {
  std::vector<int> origins(draft.vertices.size());
  std::iota(origins.begin(), origins.end(), 0);
  if (!has_slits(draft)) return origins;
  DisjointSets sectors = sectors_of(draft);
  std::map<Edge, int> vertices;  ///< (vertex, sector) to the vertex or its copy
  std::set<int> seen;
  std::vector<std::array<int, 3>> triangles = draft.triangles;
  std::map<Edge, Edge> edges;  ///< of the triangles: old to new vertices
  // Copies in the order of their vertices, then of their triangles: independent of the order of the sectors.
  std::vector<std::pair<int, int>> corners;
  for (int c = 0; c < 3 * static_cast<int>(triangles.size()); ++c) corners.emplace_back(triangles[c / 3][c % 3], c);
  std::sort(corners.begin(), corners.end());
  for (const auto& [vertex, corner] : corners) {
    const auto [found, is_new] = vertices.try_emplace({vertex, sectors.find(corner)}, vertex);
    if (is_new && !seen.insert(vertex).second) {
      found->second = draft.add_vertex(draft.vertices[vertex]);
      origins.push_back(vertex);
    }
    draft.triangles[corner / 3][corner % 3] = found->second;
  }
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      edges[{triangles[t][k], triangles[t][(k + 1) % 3]}] = {draft.triangles[t][k], draft.triangles[t][(k + 1) % 3]};
  for (DraftEdge& edge : draft.edges) std::tie(edge.from, edge.to) = edges.at({edge.from, edge.to});
  return origins;
}

}  // namespace quadrille::triangulate
