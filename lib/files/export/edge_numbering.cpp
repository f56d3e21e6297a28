#include "export/edge_numbering.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/position_text.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {
namespace {

class Numbering {
 public:
  explicit Numbering(const QuadMesh& mesh) : mesh_(mesh), node2vertex_(mesh.nodes.size(), -1) {
    result_.elem2verts.reserve(4 * mesh.num_elems());
    result_.elem2edges.reserve(4 * mesh.num_elems());
  }

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
      first_edge_.push_back(-1);
    }
    return node2vertex_[node];
  }

  /// Edges of one lower vertex form a short linked list.
  int edge_at(int elem, int side) {
    const int* corners = &result_.elem2verts[4 * elem];
    const int from = corners[side], to = corners[(side + 1) % 4];
    const NumberedEdge edge{{std::min(from, to), std::max(from, to)}, elem, side, from > to};
    const int inner = inner_node(edge);
    int* link = &first_edge_[edge.vertices[0]];
    while (*link >= 0) {
      if (result_.edges[*link].vertices[1] == edge.vertices[1] && inner_[*link] == inner) return *link;
      link = &next_edge_[*link];
    }
    const int number = *link = result_.num_edges();
    result_.edges.push_back(edge);
    inner_.push_back(inner);
    next_edge_.push_back(-1);  // after the last use of `link`, which may point into this list
    return number;
  }

  /// The node next to the lower vertex (the other vertex for order 1).
  int inner_node(const NumberedEdge& edge) const {
    return side_node(mesh_, edge.elem, edge.side, edge.is_reversed ? mesh_.order - 1 : 1);
  }

  const QuadMesh& mesh_;
  EdgeNumbering result_;
  std::vector<int> node2vertex_;
  std::vector<int> first_edge_;         ///< by lower vertex: head of its list, -1 none
  std::vector<int> next_edge_, inner_;  ///< by edge: the next of the list, -1 at its end; node that identifies it
};

}  // namespace

EdgeNumbering number_edges(const QuadMesh& mesh) { return Numbering(mesh).build(); }

std::vector<int> edge_nodes(const QuadMesh& mesh, const NumberedEdge& edge) {
  std::vector<int> nodes = side_nodes(mesh, edge.elem, edge.side);
  if (edge.is_reversed) std::reverse(nodes.begin(), nodes.end());
  return nodes;
}

void require_edges_known_by_ends(const QuadMesh& mesh, const EdgeNumbering& numbering, const char* reader) {
  std::vector<std::array<int, 2>> ends;
  for (const NumberedEdge& e : numbering.edges) ends.push_back(e.vertices);
  std::sort(ends.begin(), ends.end());
  const auto twice = std::adjacent_find(ends.begin(), ends.end());
  if (twice == ends.end()) return;
  const auto position = [&](int vertex) { return mesh.nodes[numbering.vertices[vertex]] + mesh.face.origin; };
  throw ComputeError(fmt::format("two edges join {} and {}, and {} identifies edges by their ends: refine the mesh",
                                 position_text(position((*twice)[0])), position_text(position((*twice)[1])), reader));
}

}  // namespace quadrille::exports
