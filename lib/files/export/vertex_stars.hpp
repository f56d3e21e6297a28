#pragma once
// The edges around each vertex of a quad mesh, and which of them are lines between grids.

#include <array>
#include <vector>

#include "export/edge_numbering.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {

/// The edges at a vertex, counter-clockwise; of a vertex on the boundary from one boundary edge to the next one. A
/// vertex at which the mesh touches itself has several.
struct VertexStar {
  std::vector<int> edges;
  bool is_closed = true;  ///< the vertex lies inside
};

class VertexStars {
 public:
  explicit VertexStars(const QuadMesh& mesh);

  const std::vector<VertexStar>& stars() const { return stars_; }
  const EdgeNumbering& numbering() const { return numbering_; }
  const std::array<int, 2>& ends(int edge) const { return ends_[edge]; }
  int other_end(int edge, int star) const { return ends_[edge][ends_[edge][0] == star ? 1 : 0]; }
  /// By element and side: the same as a side of the neighbour (4 elem + side); -1: the boundary.
  int across(int elem, int side) const { return across_[4 * elem + side]; }
  int edge(int elem, int side) const { return numbering_.elem2edges[4 * elem + side]; }

  /// How many further edges of the star must become lines, so that no two neighbouring ones are left out: half of each
  /// run of those that are none. Zero for an inner vertex with four edges and no line.
  int deficit(int star, const std::vector<bool>& is_line) const;

  /// Such edges: every second one of each run.
  std::vector<int> missing_lines(int star, const std::vector<bool>& is_line) const;

  /// The edge opposite to one of the four at an inner vertex without lines; -1 at any other.
  int straight_on(int star, int edge, const std::vector<bool>& is_line) const;

 private:
  void find_neighbours();
  void add_star(int corner, std::vector<bool>& is_done);

  EdgeNumbering numbering_;
  std::vector<int> across_;
  std::vector<VertexStar> stars_;
  std::vector<std::array<int, 2>> ends_;  ///< by edge: its stars
};

}  // namespace quadrille::exports
