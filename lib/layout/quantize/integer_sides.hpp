#pragma once
// The sides of the faces of a T-mesh whose arcs have integer lengths, as number lines.
//
// Positions on a side of a face are counted counter-clockwise, from 0 to the side's length; points inside an arc are
// numbered in the arc's own direction.

#include <array>
#include <utility>
#include <vector>

#include "quantize/t_mesh_faces.hpp"

namespace quadrille::quantize {

/// Position of a half-edge: side of a face, and the position on the side at which it starts.
struct SidePosition {
  int face = -1, side = 0, offset = 0;
};

class IntegerSides {
 public:
  /// `faces` and `lengths` (of the arcs, opposite sides of a face equal) must outlive it.
  IntegerSides(const std::vector<TFace>& faces, const std::vector<int>& lengths);

  const std::vector<TFace>& faces() const { return faces_; }
  /// Face -1 if a boundary arc has no face on that side.
  const SidePosition& position_of(HalfEdge h) const { return positions_[h.index()]; }
  /// Length of a side.
  int total(int face, int side) const { return totals_[face][side]; }
  /// Length of an arc.
  int arc(int a) const { return lengths_[a]; }
  /// The half-edge of a side at a position, and the position along the half-edge: 0 < number <= its length.
  std::pair<HalfEdge, int> half_edge_at(int face, int side, int position) const;

 private:
  const std::vector<TFace>& faces_;
  const std::vector<int>& lengths_;
  std::vector<SidePosition> positions_;
  std::vector<std::array<int, 4>> totals_;
};

}  // namespace quadrille::quantize
