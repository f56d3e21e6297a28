#include "export/hex_numbering.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {

namespace {

class HexNumbers {
 public:
  explicit HexNumbers(const HexMesh& mesh)
      : mesh_(mesh), node2vertex_(mesh.nodes.size(), -1), edges_(mesh.nodes.size()), faces_(mesh.nodes.size()) {
    for (int edge = 0; edge < 12; ++edge) local_edges_[edge] = local_edge_nodes(mesh.order, hex_edge_corners[edge]);
    for (int face = 0; face < 6; ++face) local_faces_[face] = local_face_nodes(mesh.order, hex_face_corners[face]);
  }

  HexNumbering build() {
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) {
      elem_nodes_ = &mesh_.elem_nodes[static_cast<std::size_t>(elem) * mesh_.nodes_per_elem()];
      for (int corner = 0; corner < 8; ++corner) add_vertex(elem_nodes_[hex_corner_node(mesh_.order, corner)]);
      for (int edge = 0; edge < 12; ++edge) add_edge(elem, edge);
      result_.elem2faces.resize(6 * (elem + 1));
      for (const int face : hex_face_order) add_face(elem, face);
    }
    return std::move(result_);
  }

 private:
  void add_vertex(int node) {
    int& vertex = node2vertex_[node];
    if (vertex < 0) {
      vertex = result_.num_vertices();
      result_.vertices.push_back(node);
    }
    result_.elem2verts.push_back(vertex);
  }

  void add_edge(int elem, int edge) {
    const std::vector<int>& local = local_edges_[edge];
    const int n = mesh_.order, from = vertex_at(local.front()), to = vertex_at(local.back());
    const bool is_reversed = from > to;
    const auto [low, high] = std::minmax(from, to);
    const int number = edges_.number({low, high, elem_nodes_[local[is_reversed ? n - 1 : 1]]});
    if (number == result_.num_edges()) result_.edges.push_back({{low, high}, elem, edge, is_reversed});
    result_.elem2edges.push_back(number);
  }

  void add_face(int elem, int face) {
    const std::vector<int>& local = local_faces_[face];
    std::array<int, 5> key{};
    for (int k = 0; k < 4; ++k) key[k] = vertex_at(hex_corner_node(mesh_.order, hex_face_corners[face][k]));
    std::sort(key.begin(), key.begin() + 4);
    key[4] = inner_face_node(local);
    const int number = faces_.number(key);
    if (number == result_.num_faces())
      result_.faces.push_back({elem, face});
    else if (NumberedHexFace& first = result_.faces[number]; first.other_elem < 0)
      first.other_elem = elem, first.other_face = face;
    else
      throw ComputeError(
          fmt::format("two faces at {} join the same vertices and cannot be distinguished: refine the "
                      "mesh, or give it order 2",
                      position_text(mesh_.nodes[elem_nodes_[local[0]]])));
    result_.elem2faces[6 * elem + face] = number;
  }

  /// The least of the nodes next to its corners, from whichever side it is seen; 0 for order 1.
  int inner_face_node(const std::vector<int>& local) const {
    const int n = mesh_.order, width = n + 1;
    if (n == 1) return 0;
    return std::min({elem_nodes_[local[width + 1]], elem_nodes_[local[width + n - 1]],
                     elem_nodes_[local[(n - 1) * width + 1]], elem_nodes_[local[(n - 1) * width + n - 1]]});
  }

  int vertex_at(int local) const { return node2vertex_[elem_nodes_[local]]; }

  const HexMesh& mesh_;
  const int* elem_nodes_ = nullptr;
  std::array<std::vector<int>, 12> local_edges_;
  std::array<std::vector<int>, 6> local_faces_;
  std::vector<int> node2vertex_;
  KeyNumbers<3> edges_;
  KeyNumbers<5> faces_;
  HexNumbering result_;
};

/// The position of a corner of the second of two equal keys. Keys end with the element and the corner there.
template <std::size_t size>
void require_distinct(const HexMesh& mesh, std::vector<std::array<int, size>>& keys, const char* what,
                      const char* reader) {
  std::sort(keys.begin(), keys.end());
  const auto twice = std::adjacent_find(keys.begin(), keys.end(), [](const auto& a, const auto& b) {
    return std::equal(a.begin(), a.end() - 1, b.begin());
  });
  if (twice == keys.end()) return;
  throw ComputeError(fmt::format("two {} at {} join the same vertices, and {} identifies {} by their vertices: refine",
                                 what, position_text(mesh.nodes[twice->back()]), reader, what));
}

std::vector<int> nodes_at(const HexMesh& mesh, int elem, std::vector<int> local) {
  const std::size_t first = static_cast<std::size_t>(elem) * mesh.nodes_per_elem();
  for (int& node : local) node = mesh.elem_nodes[first + node];
  return local;
}

/// The elements of the first layer at their bottom; nodes keep their numbers.
QuadMesh bottom_quads(const HexMesh& mesh) {
  QuadMesh quads;
  quads.order = mesh.order;
  quads.nodes.resize(mesh.nodes.size());
  quads.elem_block.resize(mesh.num_quads);
  for (int elem = 0; elem < mesh.num_quads; ++elem) {
    const auto first = mesh.elem_nodes.begin() + static_cast<std::ptrdiff_t>(elem) * mesh.nodes_per_elem();
    quads.elem_nodes.insert(quads.elem_nodes.end(), first, first + quads.nodes_per_elem());
  }
  return quads;
}

}  // namespace

HexNumbering number_parts(const HexMesh& mesh) { return HexNumbers(mesh).build(); }

std::vector<int> edge_nodes(const HexMesh& mesh, int elem, int edge) {
  return nodes_at(mesh, elem, local_edge_nodes(mesh.order, hex_edge_corners[edge]));
}

std::vector<int> edge_nodes(const HexMesh& mesh, const NumberedEdge& edge) {
  std::vector<int> nodes = edge_nodes(mesh, edge.elem, edge.edge);
  if (edge.is_reversed) std::reverse(nodes.begin(), nodes.end());
  return nodes;
}

std::vector<int> local_edge_nodes(int order, const std::array<int, 2>& corners) {
  const int start = hex_corner_node(order, corners[0]), step = (hex_corner_node(order, corners[1]) - start) / order;
  std::vector<int> nodes;
  for (int k = 0; k <= order; ++k) nodes.push_back(start + k * step);
  return nodes;
}

std::vector<int> local_face_nodes(int order, const std::array<int, 4>& corners) {
  const int start = hex_corner_node(order, corners[0]);
  const int along = (hex_corner_node(order, corners[1]) - start) / order;
  const int across = (hex_corner_node(order, corners[3]) - start) / order;
  std::vector<int> nodes;
  for (int b = 0; b <= order; ++b)
    for (int a = 0; a <= order; ++a) nodes.push_back(start + a * along + b * across);
  return nodes;
}

std::vector<int> face_nodes(const HexMesh& mesh, int elem, int face) {
  return face_nodes(mesh, elem, hex_face_corners[face]);
}

std::vector<int> face_nodes(const HexMesh& mesh, int elem, const std::array<int, 4>& corners) {
  return nodes_at(mesh, elem, local_face_nodes(mesh.order, corners));
}

HexMesh turned_along_chords(const HexMesh& mesh) {
  const std::vector<int> corners = chord_corners(bottom_quads(mesh));
  const int n = mesh.order, width = n + 1;
  HexMesh turned = mesh;
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const int corner = corners[elem % mesh.num_quads], next = (corner + 1) % 4;
    const std::size_t first = static_cast<std::size_t>(elem) * mesh.nodes_per_elem();
    int* node = &turned.elem_nodes[first];
    for (int k = 0; k <= n; ++k)
      for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i)
          *node++ = mesh.elem_nodes[first + k * width * width + local_side_node(n, corner, i) +
                                    local_side_node(n, next, j) - local_side_node(n, next, 0)];
  }
  for (HexFaceGroup& group : turned.face_groups)
    for (std::size_t k = 0; k < group.faces.size(); ++k)
      if (group.faces[k] < 4) group.faces[k] = (group.faces[k] + 4 - corners[group.elems[k] % mesh.num_quads]) % 4;
  return turned;
}

HexNumbering number_directed_parts(const HexMesh& turned) {
  HexNumbering numbering = number_parts(turned);
  for (NumberedEdge& edge : numbering.edges) {
    if (edge.is_reversed) std::swap(edge.vertices[0], edge.vertices[1]);
    edge.is_reversed = false;
  }
  return numbering;
}

void require_known_by_vertices(const HexMesh& mesh, const HexNumbering& numbering, const char* reader) {
  std::vector<std::array<int, 3>> edges;
  for (const NumberedEdge& e : numbering.edges)
    edges.push_back({e.vertices[0], e.vertices[1], numbering.vertices[e.vertices[0]]});
  require_distinct(mesh, edges, "edges", reader);
  std::vector<std::array<int, 5>> faces;
  for (const NumberedHexFace& f : numbering.faces) {
    std::array<int, 5> key{};
    for (int k = 0; k < 4; ++k) key[k] = numbering.vertex(f.elem, hex_face_corners[f.face][k]);
    std::sort(key.begin(), key.begin() + 4);
    key[4] = numbering.vertices[key[0]];
    faces.push_back(key);
  }
  require_distinct(mesh, faces, "faces", reader);
}

std::vector<GroupFace> faces_once(const HexFaceGroup& group, const HexNumbering& numbering) {
  std::vector<GroupFace> faces;
  for (std::size_t k = 0; k < group.elems.size(); ++k) {
    const GroupFace at{group.elems[k], group.faces[k]};
    const NumberedHexFace& face = numbering.faces[numbering.face(at.elem, at.face)];
    if (!group.is_interface || (face.elem == at.elem && face.face == at.face)) faces.push_back(at);
  }
  return faces;
}

}  // namespace quadrille::exports
