#pragma once
// The elements of a mesh around one of its vertices: m x m in each sector, as refine/tip_rings replaces them.

#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "model/quad_mesh.hpp"

namespace quadrille::refine {

using QuadSide = std::pair<int, int>;  ///< element and side

class TipPatch {
 public:
  struct Cell {
    int elem = -1;
    int corner = 0;  ///< of the element, nearest to the tip
  };

  /// `cells`: m x m, i fastest; i grows along the side that starts at the tip, j along the one that ends there.
  TipPatch(const QuadMesh& mesh, int width, std::vector<Cell> cells);

  int width() const { return width_; }
  const Cell& cell(int i, int j) const { return cells_[j * width_ + i]; }
  bool contains_any(const std::set<int>& elems) const;
  /// Of the vertices (0, 0) to (m, m).
  int vertex(int i, int j) const;
  /// Vertices of the outer edges, from the one on the side j = 0 to that on the side i = 0: 2 m + 1.
  int outer_vertex(int k) const { return k <= width_ ? vertex(width_, k) : vertex(2 * width_ - k, width_); }
  /// Outer edge k, as a side of an element of the patch.
  QuadSide outer_edge(int k) const;
  /// Edge k from the tip along the side j = 0, which starts at the tip, or along the side i = 0, which ends there.
  QuadSide wall_edge(bool is_at_start, int k) const;

 private:
  const QuadMesh& mesh_;
  int width_;
  std::vector<Cell> cells_;
};

/// One for each element at the node `tip`. None where one has no room, which is a row and a column more, or an element
/// at an interface, or two curves on one side. `curves`: of the sides on the boundary. The mesh must outlive them.
/// O(n log n) for n elements.
std::vector<TipPatch> tip_patches(const QuadMesh& mesh, int tip, int width, const std::map<QuadSide, int>& curves);

}  // namespace quadrille::refine
