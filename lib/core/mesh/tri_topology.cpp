#include "mesh/tri_topology.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "base/error.hpp"

namespace quadrille::mesh {
namespace {

/// One side of an edge, with its element.
struct HalfEdge {
  int low = 0, high = 0;
  int elem = 0, local = 0;
  bool is_forward = false;  ///< directed from the lower to the higher vertex

  auto key() const { return std::tie(low, high, elem, local); }
};

std::vector<HalfEdge> sorted_half_edges(const TriMesh& mesh) {
  std::vector<HalfEdge> halves;
  halves.reserve(3 * mesh.elem2vertices.size());
  for (int e = 0; e < mesh.num_elems(); ++e) {
    for (int k = 0; k < 3; ++k) {
      const int a = mesh.elem2vertices[e][k], b = mesh.elem2vertices[e][(k + 1) % 3];
      if (a == b) throw FormatError(fmt::format("element {} uses vertex {} twice", e, a));
      halves.push_back({std::min(a, b), std::max(a, b), e, k, a < b});
    }
  }
  std::sort(halves.begin(), halves.end(), [](const HalfEdge& a, const HalfEdge& b) { return a.key() < b.key(); });
  return halves;
}

bool same_edge(const HalfEdge& a, const HalfEdge& b) { return a.low == b.low && a.high == b.high; }

void link(TriTopology& topology, const HalfEdge& a, const HalfEdge& b) {
  topology.elem2neighbors[a.elem][a.local] = b.elem;
  topology.elem2neighbor_edges[a.elem][a.local] = b.local;
}

/// Adds the edge whose half-edges are [first, last).
void add_edge(TriTopology& topology, const HalfEdge* first, const HalfEdge* last) {
  if (last - first > 2) {
    throw FormatError(fmt::format("elements {}, {} and {} share the edge of vertices {} and {}", first[0].elem,
                                  first[1].elem, first[2].elem, first->low, first->high));
  }
  const int edge = static_cast<int>(topology.edge2vertices.size());
  topology.edge2vertices.push_back({first->low, first->high});
  topology.edge2elems.push_back({first->elem, -1});
  topology.elem2edges[first->elem][first->local] = edge;
  if (last - first == 1) return;
  if (first[0].is_forward == first[1].is_forward) {
    throw FormatError(fmt::format("elements {} and {} traverse the edge of vertices {} and {} in the same direction",
                                  first[0].elem, first[1].elem, first->low, first->high));
  }
  topology.edge2elems.back()[1] = first[1].elem;
  topology.elem2edges[first[1].elem][first[1].local] = edge;
  link(topology, first[0], first[1]);
  link(topology, first[1], first[0]);
}

void place_boundary_edges(const TriMesh& mesh, TriTopology& topology) {
  const int count = static_cast<int>(mesh.boundary_edges.size());
  for (int b = 0; b < count; ++b) {
    const auto& [elem, edge, curve, t0, t1] = mesh.boundary_edges[b];
    if (elem < 0 || elem >= mesh.num_elems() || edge < 0 || edge > 2) {
      throw FormatError(fmt::format("boundary edge {} names no edge of the mesh (element {}, edge {})", b, elem, edge));
    }
    if (topology.elem2neighbors[elem][edge] >= 0) {
      throw FormatError(fmt::format("boundary edge {} lies between elements {} and {}", b, elem,
                                    topology.elem2neighbors[elem][edge]));
    }
    int& known = topology.elem2boundary_edge[elem][edge];
    if (known >= 0) throw FormatError(fmt::format("boundary edges {} and {} are the same edge", known, b));
    known = b;
  }
  for (int e = 0; e < mesh.num_elems(); ++e) {
    for (int k = 0; k < 3; ++k) {
      if (topology.elem2neighbors[e][k] < 0 && topology.elem2boundary_edge[e][k] < 0) {
        throw FormatError(fmt::format("edge {} of element {} has neither neighbour nor boundary curve", k, e));
      }
    }
  }
}

}  // namespace

TriTopology tri_topology(const TriMesh& mesh) {
  const auto halves = sorted_half_edges(mesh);
  TriTopology topology;
  const std::array<int, 3> none{-1, -1, -1};
  topology.elem2edges.assign(mesh.num_elems(), none);
  topology.elem2neighbors = topology.elem2neighbor_edges = topology.elem2boundary_edge = topology.elem2edges;
  const HalfEdge* const end = halves.data() + halves.size();
  for (const HalfEdge* first = halves.data(); first != end;) {
    const HalfEdge* last = first + 1;
    while (last != end && same_edge(*first, *last)) ++last;
    add_edge(topology, first, last);
    first = last;
  }
  place_boundary_edges(mesh, topology);
  return topology;
}

}  // namespace quadrille::mesh
