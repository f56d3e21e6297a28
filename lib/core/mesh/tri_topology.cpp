#include "mesh/tri_topology.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "spectral/orthogonal_basis.hpp"
#include "spectral/tri_map.hpp"

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

std::vector<spectral::TriMap> tri_maps(const TriMesh& mesh) {
  std::vector<spectral::TriMap> maps;
  maps.reserve(mesh.elem2vertices.size());
  const int num_nodes = spectral::num_tri_modes(mesh.order);
  std::size_t next_curved = 0;
  for (int e = 0; e < mesh.num_elems(); ++e) {
    if (next_curved < mesh.curved_elems.size() && mesh.curved_elems[next_curved] == e) {
      maps.emplace_back(mesh.order, &mesh.curved_nodes[next_curved * num_nodes]);
      ++next_curved;
    } else {
      const auto& [a, b, c] = mesh.elem2vertices[e];
      maps.emplace_back(std::array<Vec2, 3>{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
    }
  }
  return maps;
}

double least_angle(const TriMesh& mesh) {
  double least = pi;
  for (const auto& elem : mesh.elem2vertices) {
    for (int k = 0; k < 3; ++k) {
      const Vec2 a = mesh.vertices[elem[(k + 1) % 3]] - mesh.vertices[elem[k]];
      const Vec2 b = mesh.vertices[elem[(k + 2) % 3]] - mesh.vertices[elem[k]];
      least = std::min(least, std::atan2(cross(a, b), dot(a, b)));
    }
  }
  return least;
}

namespace {

constexpr std::array<int, 3> image_edges{2, 1, 0};  // of the element with its second and third vertex exchanged

/// By node of an element: the node of the half whose mirror image it is in the image of the element.
std::vector<int> image_nodes(int order) {
  const std::vector<Vec2>& nodes = spectral::tri_nodes(order);
  std::vector<int> from;
  for (const Vec2 node : nodes) {
    const Vec2 exchanged{node.y, node.x};
    const auto nearer = [&](Vec2 a, Vec2 b) { return distance(a, exchanged) < distance(b, exchanged); };
    from.push_back(static_cast<int>(std::min_element(nodes.begin(), nodes.end(), nearer) - nodes.begin()));
  }
  return from;
}

/// Appends the images of vertices and elements. By vertex of the half: its image, on the line itself.
void add_elements(const TriMesh& half, const curve::MirroredFace& face, const curve::SymmetryLine& line,
                  TriMesh& whole) {
  constexpr int unknown = -1;
  std::vector<int> image(half.vertices.size(), unknown);
  for (const BoundaryEdge& edge : half.boundary_edges)
    if (face.copy[edge.curve] < 0)
      for (const int end : {edge.edge, (edge.edge + 1) % 3}) {
        const int vertex = half.elem2vertices[edge.elem][end];
        image[vertex] = vertex;
      }
  for (std::size_t v = 0; v < image.size(); ++v)
    if (image[v] == unknown) {
      image[v] = static_cast<int>(whole.vertices.size());
      whole.vertices.push_back(line(half.vertices[v]));
    }
  for (const auto& [a, b, c] : half.elem2vertices) whole.elem2vertices.push_back({image[a], image[c], image[b]});
  whole.elem_layer.insert(whole.elem_layer.end(), half.elem_layer.begin(), half.elem_layer.end());
}

void add_curved_nodes(const TriMesh& half, const curve::SymmetryLine& line, TriMesh& whole) {
  const std::vector<int> from = image_nodes(half.order);
  for (std::size_t i = 0; i < half.curved_elems.size(); ++i) {
    whole.curved_elems.push_back(half.curved_elems[i] + half.num_elems());
    for (const int node : from)
      whole.curved_nodes.push_back(line(half.curved_nodes[i * from.size() + static_cast<std::size_t>(node)]));
  }
}

std::vector<BoundaryEdge> mirrored_boundary(const TriMesh& half, const curve::MirroredFace& face) {
  std::vector<BoundaryEdge> edges;
  for (BoundaryEdge edge : half.boundary_edges) {
    if (face.copy[edge.curve] < 0) continue;
    const Nurbs& curve = half.face.curves[edge.curve];
    const double ends = curve.begin() + curve.end();
    edges.push_back({edge.elem, edge.edge, face.copy[edge.curve], edge.t0, edge.t1});
    edges.push_back({edge.elem + half.num_elems(), image_edges[edge.edge], face.image[edge.curve],
                     edge.t1 == curve.end() ? curve.begin() : ends - edge.t1,
                     edge.t0 == curve.begin() ? curve.end() : ends - edge.t0});
  }
  std::sort(edges.begin(), edges.end(), [](const BoundaryEdge& a, const BoundaryEdge& b) {
    return std::tie(a.curve, a.t0) < std::tie(b.curve, b.t0);
  });
  return edges;
}

}  // namespace

TriMesh mirrored_mesh(const TriMesh& half, const curve::MirroredFace& face, const curve::SymmetryLine& line) {
  TriMesh whole = half;
  whole.face = face.whole;
  add_elements(half, face, line, whole);
  add_curved_nodes(half, line, whole);
  whole.boundary_edges = mirrored_boundary(half, face);
  return whole;
}

}  // namespace quadrille::mesh
