#pragma once
// Vertices and edges of a quad mesh, numbered as formats with edge tables require: in the order in which a loop over
// the elements meets them, corner by corner and side by side; an edge runs from its vertex of lower number to the
// other.
//
// Index base 0. Two edges between the same two vertices stay separate: their inner nodes differ (order >= 2).

#include <array>
#include <vector>

#include "model/quad_mesh.hpp"

namespace quadrille::exports {

struct NumberedEdge {
  std::array<int, 2> vertices{};  ///< the lower number first: the edge's own direction
  int elem = 0, side = 0;         ///< the first element that has this edge, and its side
  bool is_reversed = false;       ///< that element's counter-clockwise direction is the opposite one
};

struct EdgeNumbering {
  std::vector<int> vertices;    ///< vertex -> mesh node
  std::vector<int> elem2verts;  ///< 4 per element, corners counter-clockwise
  std::vector<int> elem2edges;  ///< 4 per element, by side
  std::vector<NumberedEdge> edges;

  int num_vertices() const { return static_cast<int>(vertices.size()); }
  int num_edges() const { return static_cast<int>(edges.size()); }
};

EdgeNumbering number_edges(const QuadMesh& mesh);

/// Mesh nodes of an edge in its own direction, both ends included.
std::vector<int> edge_nodes(const QuadMesh& mesh, const NumberedEdge& edge);

/// Throws ComputeError with the position if two edges join the same two vertices, which `reader` could not distinguish.
void require_edges_known_by_ends(const QuadMesh& mesh, const EdgeNumbering& numbering, const char* reader);

}  // namespace quadrille::exports
