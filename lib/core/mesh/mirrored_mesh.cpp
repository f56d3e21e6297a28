#include "mesh/mirrored_mesh.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include "spectral/tri_map.hpp"

namespace quadrille::mesh {
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
