#pragma once
// Lines through the integer grids of the faces of a T-mesh that continue the lines that stop at its T-junctions.

#include <array>
#include <set>
#include <vector>

#include "model/separatrix_graph.hpp"
#include "quantize/integer_sides.hpp"

namespace quadrille::quantize {

struct IsoLines {
  /// Of each arc: the numbers of its points where lines cross it, 0 < number < length.
  std::vector<std::set<int>> crossings;
  /// Of each face: the lines from side 0 to side 2 and from side 1 to side 3, by the position where they start.
  std::vector<std::array<std::set<int>, 2>> lines;
};

/// Each line continues through face after face until it meets the boundary, or a T-junction from the other side, whose
/// line it joins.
IsoLines iso_lines(const ArcGraph& t_mesh, const IntegerSides& sides);

}  // namespace quadrille::quantize
