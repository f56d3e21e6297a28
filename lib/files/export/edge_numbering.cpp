#include "export/edge_numbering.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {

namespace {

class Numbering {
 public:
  explicit Numbering(const QuadMesh& mesh)
      : mesh_(mesh), node2vertex_(mesh.nodes.size(), -1), numbers_(mesh.nodes.size()) {}

  EdgeNumbering build() {
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) {
      for (int side = 0; side < 4; ++side) result_.elem2verts.push_back(vertex_at(side_start(mesh_, elem, side)));
      for (int side = 0; side < 4; ++side) result_.elem2edges.push_back(edge_at(elem, side));
    }
    return std::move(result_);
  }

 private:
  int vertex_at(int node) {
    if (node2vertex_[node] < 0) {
      node2vertex_[node] = result_.num_vertices();
      result_.vertices.push_back(node);
    }
    return node2vertex_[node];
  }

  /// An edge is known by its ends and the node next to the lower one, the other end for order 1.
  int edge_at(int elem, int side) {
    const int from = result_.vertex(elem, side), to = result_.vertex(elem, side + 1);
    const NumberedEdge edge{{std::min(from, to), std::max(from, to)}, elem, side, from > to};
    const int inner = side_node(mesh_, elem, side, edge.is_reversed ? mesh_.order - 1 : 1);
    const int number = numbers_.number({edge.vertices[0], edge.vertices[1], inner});
    if (number == result_.num_edges()) result_.edges.push_back(edge);
    return number;
  }

  const QuadMesh& mesh_;
  EdgeNumbering result_;
  std::vector<int> node2vertex_;
  KeyNumbers<3> numbers_;
};

struct Side {
  int elem = -1, side = 0;
};

/// The directions of all edges, found chord by chord.
class Directions {
 public:
  explicit Directions(const QuadMesh& mesh)
      : numbering_(number_parts(mesh)),
        edge_sides_(numbering_.num_edges()),
        is_turned_(numbering_.num_edges()),
        is_known_(numbering_.num_edges()) {
    for (int k = 0; k < 4 * mesh.num_elems(); ++k) {
      auto& sides = edge_sides_[numbering_.elem2edges[k]];
      sides[sides[0].elem < 0 ? 0 : 1] = {k / 4, k % 4};
    }
    for (int edge = 0; edge < numbering_.num_edges(); ++edge)
      if (!is_known_[edge]) direct_chord(edge);
  }

  /// The corner from which its own side runs counter-clockwise, and the side before it clockwise.
  int first_corner(int elem) const {
    int corner = 0;
    while (corner < 3 && !(is_counter_clockwise({elem, corner}) && !is_counter_clockwise({elem, (corner + 3) % 4})))
      ++corner;
    return corner;
  }

 private:
  int edge_at(Side at) const { return numbering_.elem2edges[4 * at.elem + at.side]; }

  /// Whether the edge runs counter-clockwise around the element.
  bool is_counter_clockwise(Side at) const {
    const NumberedEdge& edge = numbering_.edges[edge_at(at)];
    const bool is_first = edge.elem == at.elem && edge.edge == at.side;
    return is_turned_[edge_at(at)] != (is_first != edge.is_reversed);
  }

  void direct_chord(int first) {
    is_known_[first] = true;
    std::vector<int> open{first};
    while (!open.empty()) {
      const int edge = open.back();
      open.pop_back();
      for (const Side at : edge_sides_[edge])
        if (at.elem >= 0) direct_opposite(at, open);
    }
  }

  /// Parallel sides run in opposite directions around an element.
  void direct_opposite(Side at, std::vector<int>& open) {
    const Side opposite{at.elem, (at.side + 2) % 4};
    const int edge = edge_at(opposite);
    if (is_known_[edge]) return;
    is_turned_[edge] = is_counter_clockwise(opposite) == is_counter_clockwise(at);
    is_known_[edge] = true;
    open.push_back(edge);
  }

  EdgeNumbering numbering_;
  std::vector<std::array<Side, 2>> edge_sides_;
  std::vector<bool> is_turned_, is_known_;
};

/// The nodes of an element in tensor order from a corner on: the first coordinate runs along the side of that number.
std::vector<int> nodes_from_corner(const QuadMesh& mesh, int elem, int corner) {
  const int n = mesh.order, next = (corner + 1) % 4;
  const int* nodes = &mesh.elem_nodes[elem * mesh.nodes_per_elem()];
  std::vector<int> result;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      result.push_back(
          nodes[local_side_node(n, corner, i) + local_side_node(n, next, j) - local_side_node(n, next, 0)]);
  return result;
}

}  // namespace

EdgeNumbering number_parts(const QuadMesh& mesh) { return Numbering(mesh).build(); }

std::vector<int> edge_nodes(const QuadMesh& mesh, const NumberedEdge& edge) {
  std::vector<int> nodes = side_nodes(mesh, edge.elem, edge.edge);
  if (edge.is_reversed) std::reverse(nodes.begin(), nodes.end());
  return nodes;
}

void require_known_by_vertices(const QuadMesh& mesh, const EdgeNumbering& numbering, const char* reader) {
  std::vector<std::array<int, 2>> ends;
  for (const NumberedEdge& e : numbering.edges) ends.push_back(e.vertices);
  std::sort(ends.begin(), ends.end());
  const auto twice = std::adjacent_find(ends.begin(), ends.end());
  if (twice == ends.end()) return;
  const auto position = [&](int vertex) { return mesh.nodes[numbering.vertices[vertex]] + mesh.face.origin; };
  throw ComputeError(fmt::format("two edges join {} and {}, and {} identifies edges by their ends: refine the mesh",
                                 position_text(position((*twice)[0])), position_text(position((*twice)[1])), reader));
}

std::vector<int> chord_corners(const QuadMesh& mesh) {
  const Directions directions(mesh);
  std::vector<int> corners;
  for (int elem = 0; elem < mesh.num_elems(); ++elem) corners.push_back(directions.first_corner(elem));
  return corners;
}

QuadMesh turned_along_chords(const QuadMesh& mesh) {
  const std::vector<int> corners = chord_corners(mesh);
  QuadMesh turned = mesh;
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const std::vector<int> nodes = nodes_from_corner(mesh, elem, corners[elem]);
    std::copy(nodes.begin(), nodes.end(), turned.elem_nodes.begin() + elem * mesh.nodes_per_elem());
  }
  for (auto* edges : {&turned.boundary_edges, &turned.interface_edges})
    for (QuadBoundaryEdge& edge : *edges) edge.side = (edge.side + 4 - corners[edge.elem]) % 4;
  return turned;
}

EdgeNumbering number_directed_parts(const QuadMesh& turned) {
  EdgeNumbering numbering = number_parts(turned);
  for (NumberedEdge& edge : numbering.edges) {
    const bool runs_clockwise = edge.edge >= 2;
    if (edge.is_reversed != runs_clockwise) std::swap(edge.vertices[0], edge.vertices[1]);
    edge.is_reversed = runs_clockwise;
  }
  return numbering;
}

}  // namespace quadrille::exports
