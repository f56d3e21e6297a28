#pragma once
// Vertices and edges of a quad mesh, numbered as formats with edge tables require: in the order in which a loop over
// the elements meets them, corner by corner and side by side; an edge runs from its vertex of lower number to the
// other.
//
// Index base 0. Two edges between the same two vertices stay separate: their inner nodes differ (order >= 2).
//
// For Nektar++ edges are directed so that opposite sides of every element are parallel, and elements start where both
// directions begin. A chord crosses each element from one side to the opposite one. Edges that run from its right to
// its left are parallel. Such directions always exist: a chord of a mesh in the plane has a left and a right, so it
// cannot return to an edge with both exchanged. A chord that crosses itself passes an element twice, once through each
// pair of sides.

#include <array>
#include <vector>

#include "model/quad_mesh.hpp"

namespace quadrille::exports {

struct NumberedEdge {
  std::array<int, 2> vertices{};  ///< the lower number first: the edge's own direction
  int elem = 0, edge = 0;         ///< the first element that has this edge, and its number there: of a quad the side
  bool is_reversed =
      false;  ///< the direction there, counter-clockwise or that of hex_edge_corners, is the opposite one
};

struct EdgeNumbering {
  std::vector<int> vertices;    ///< vertex -> mesh node
  std::vector<int> elem2verts;  ///< 4 per element, corners counter-clockwise; 8 of a hexahedron
  std::vector<int> elem2edges;  ///< 4 per element, by side; 12 of a hexahedron
  std::vector<NumberedEdge> edges;

  int num_vertices() const { return static_cast<int>(vertices.size()); }
  int num_edges() const { return static_cast<int>(edges.size()); }
  /// Corners are counted modulo 4.
  int vertex(int elem, int corner) const { return elem2verts[4 * elem + corner % 4]; }
};

/// Numbers keys in the order of their first use. Keys of one first entry form a short linked list.
template <std::size_t size>
class KeyNumbers {
 public:
  using Key = std::array<int, size>;

  /// First entries are below `num_firsts`.
  explicit KeyNumbers(std::size_t num_firsts) : first_(num_firsts, -1) {}

  int number(const Key& key) {
    int* link = &first_[key[0]];
    while (*link >= 0) {
      if (keys_[*link] == key) return *link;
      link = &next_[*link];
    }
    const int number = *link = static_cast<int>(keys_.size());
    keys_.push_back(key);
    next_.push_back(-1);  // after the last use of `link`, which may point into this list
    return number;
  }

 private:
  std::vector<int> first_, next_;
  std::vector<Key> keys_;
};

/// Linear cost.
EdgeNumbering number_parts(const QuadMesh& mesh);

/// The order + 1 mesh nodes of an edge in its own direction.
std::vector<int> edge_nodes(const QuadMesh& mesh, const NumberedEdge& edge);

/// Throws ComputeError with the position if two edges join the same two vertices, which `reader` could not distinguish.
void require_known_by_vertices(const QuadMesh& mesh, const EdgeNumbering& numbering, const char* reader);

/// For each element the corner where the directions of its sides begin. The edge of least number on a chord determines
/// the direction of all (from its vertex of lower number, as number_parts has it). Linear cost.
std::vector<int> chord_corners(const QuadMesh& mesh);

/// The same elements, each with its nodes in the order that starts at its chord_corners: sides 0 and 2 run along xi1,
/// sides 1 and 3 along xi2. Edges of boundaries and interfaces keep their nodes.
QuadMesh turned_along_chords(const QuadMesh& mesh);

/// number_parts of a mesh that is turned along its chords, with edges in the directions of their chords, which need not
/// begin at the vertex of lower number.
EdgeNumbering number_directed_parts(const QuadMesh& turned);

}  // namespace quadrille::exports
