#include "export/periodic_vertices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/disjoint_sets.hpp"
#include "base/position_text.hpp"
#include "export/periodic_edges.hpp"

namespace quadrille::exports {
namespace {

/// Vertices and edges that are one.
struct Identified {
  DisjointSets vertices, edges;
};

Identified identified(const QuadMesh& mesh, const EdgeNumbering& numbering, Motions motions) {
  Identified sets{DisjointSets(numbering.num_vertices()), DisjointSets(numbering.num_edges())};
  for (const PeriodicEdges& pair : periodic_edges(mesh)) {
    if (motions == Motions::translations && mesh.face.periodic_pairs[pair.pair].angle != 0) continue;
    const QuadBoundaryEdge &first = mesh.boundary_edges[pair.first], &second = mesh.boundary_edges[pair.second];
    const auto vertex = [&](const QuadBoundaryEdge& e, int end) {
      return numbering.elem2verts[4 * e.elem + (e.side + end) % 4];
    };
    const auto edge = [&](const QuadBoundaryEdge& e) { return numbering.elem2edges[4 * e.elem + e.side]; };
    sets.vertices.unite(vertex(first, 0), vertex(second, 1));
    sets.vertices.unite(vertex(first, 1), vertex(second, 0));
    sets.edges.unite(edge(first), edge(second));
  }
  return sets;
}

/// An edge whose two ends are also those of another edge, or one vertex; -1 if each edge is known by its ends.
int ambiguous_edge(const EdgeNumbering& numbering, Identified& sets) {
  std::vector<std::array<int, 3>> edges;  // ends, number
  for (int e = 0; e < numbering.num_edges(); ++e) {
    if (sets.edges.find(e) != e) continue;
    const auto [a, b] = numbering.edges[e].vertices;
    const auto [low, high] = std::minmax({sets.vertices.find(a), sets.vertices.find(b)});
    if (low == high) return e;
    edges.push_back({low, high, e});
  }
  std::sort(edges.begin(), edges.end());
  const auto twice = std::adjacent_find(edges.begin(), edges.end(), [](const auto& one, const auto& other) {
    return one[0] == other[0] && one[1] == other[1];
  });
  return twice == edges.end() ? -1 : (*twice)[2];
}

}  // namespace

PeriodicVertices periodic_vertices(const QuadMesh& mesh, const EdgeNumbering& numbering, Motions motions,
                                   const char* reader) {
  const CadFace& face = mesh.face;
  const std::vector<PeriodicPair> pairs = motions == Motions::all ? face.periodic_pairs : translated_pairs(face);
  if (pairs.empty()) return {};
  Identified sets = identified(mesh, numbering, motions);
  PeriodicVertices result;
  if (const int edge = ambiguous_edge(numbering, sets); edge >= 0) {
    const std::vector<int> nodes = edge_nodes(mesh, numbering.edges[edge]);
    const auto position = [&](int node) { return position_text(mesh.nodes[node] + face.origin); };
    result.loss = periodic_loss(
        face, pairs,
        fmt::format("{} identifies edges by their ends, and the edge from {} to {} would have those of another one: "
                    "refine to at least three elements from side to side; sides that meet in a corner stay apart",
                    reader, position(nodes.front()), position(nodes.back())));
    return result;
  }
  for (int v = 0; v < numbering.num_vertices(); ++v) result.same.push_back(sets.vertices.find(v));
  return result;
}

}  // namespace quadrille::exports
