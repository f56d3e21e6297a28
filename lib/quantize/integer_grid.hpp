#pragma once
// The integer grids of the faces of a T-mesh whose arcs have integer lengths, and the lines in them that T-junctions
// ask for (quantize/extend_lines.hpp).
//
// Positions on a side of a face are counted counter-clockwise, from 0 to the side's length; numbers of the points
// inside an arc in the arc's own direction.

#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "model/arc_graph.hpp"
#include "quantize/t_mesh_faces.hpp"

namespace quadrille::quantize {

/// Where a half-edge lies: side of a face, and the position on the side at which it starts.
struct SidePosition {
  int face = -1, side = 0, offset = 0;
};

class IntegerSides {
 public:
  /// `faces` and `lengths` (of the arcs, opposite sides of a face equal) must outlive it.
  IntegerSides(const std::vector<TFace>& faces, const std::vector<int>& lengths);

  const std::vector<TFace>& faces() const { return faces_; }
  /// Face -1 where a boundary arc has no face on that side.
  const SidePosition& place(HalfEdge h) const { return places_[h.index()]; }
  int total(int face, int side) const { return totals_[face][side]; }
  int arc(int a) const { return lengths_[a]; }
  /// The half-edge of a side at a position, and the position along the half-edge: 0 < number <= its length.
  std::pair<HalfEdge, int> half_edge_at(int face, int side, int position) const;

 private:
  const std::vector<TFace>& faces_;
  const std::vector<int>& lengths_;
  std::vector<SidePosition> places_;
  std::vector<std::array<int, 4>> totals_;
};

/// All grid lines that T-junctions ask for: each goes on through face after face until it meets a T-junction from the
/// other side or the boundary.
class GridLines {
 public:
  GridLines(const SeparatrixGraph& t_mesh, const IntegerSides& sides);

  std::vector<std::set<int>> marks;  ///< of each arc: the numbers of its points where lines cross it
  /// Of each face: the lines from side 0 to side 2 and from side 1 to side 3, by the position where they start.
  std::vector<std::array<std::set<int>, 2>> lines;

 private:
  void ask(int face, int side, int position);
  void reach(int face, int side, int position);

  struct Asked {
    int face = 0, direction = 0, offset = 0;
  };
  const SeparatrixGraph& t_mesh_;
  const IntegerSides& sides_;
  std::vector<Asked> asked_;
};

/// Where on their arcs the marked points lie: shares of the arc's length, by number. Each is moved to where the line
/// through it comes from and goes to, so that lines run straight through the faces' transfinite maps; points of one arc
/// keep at least a quarter of their even distance.
std::vector<std::map<int, double>> mark_shares(const IntegerSides& sides, const GridLines& grid,
                                               const std::vector<double>& arc_lengths);

/// Share of a side's length at a position that is a node or marked.
double side_fraction(const IntegerSides& sides, const std::vector<std::map<int, double>>& shares,
                     const std::vector<double>& arc_lengths, int face, int side, int position);

}  // namespace quadrille::quantize
