#include "export/chord_directions.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "model/quad_mesh.hpp"

namespace quadrille::exports {
namespace {

struct Side {
  int elem = -1, side = 0;
};

/// The directions of all edges, found chord by chord.
class Directions {
 public:
  explicit Directions(const QuadMesh& mesh)
      : numbering_(number_edges(mesh)),
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
    const bool is_first = edge.elem == at.elem && edge.side == at.side;
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

QuadMesh turned_along_chords(const QuadMesh& mesh) {
  const Directions directions(mesh);
  QuadMesh turned = mesh;
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const std::vector<int> nodes = nodes_from_corner(mesh, elem, directions.first_corner(elem));
    std::copy(nodes.begin(), nodes.end(), turned.elem_nodes.begin() + elem * mesh.nodes_per_elem());
  }
  for (QuadBoundaryEdge& edge : turned.boundary_edges)
    edge.side = (edge.side + 4 - directions.first_corner(edge.elem)) % 4;
  return turned;
}

EdgeNumbering number_directed_edges(const QuadMesh& turned) {
  EdgeNumbering numbering = number_edges(turned);
  for (NumberedEdge& edge : numbering.edges) {
    const bool runs_clockwise = edge.side >= 2;
    if (edge.is_reversed != runs_clockwise) std::swap(edge.vertices[0], edge.vertices[1]);
    edge.is_reversed = runs_clockwise;
  }
  return numbering;
}

}  // namespace quadrille::exports
