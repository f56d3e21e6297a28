#pragma once
// The directed curves of a region that inner curves divide, and the loops that they form.

#include <vector>

#include "heal/loop.hpp"

namespace quadrille::sew {

/// A curve with the region on its left.
struct SideOfCurve {
  heal::LoopCurve curve;
  int from = 0, to = 0;  ///< nodes
  int twin = -1;         ///< the other side of an inner curve, in the opposite direction; -1: a curve of the boundary
};

/// The loops, as numbers of sides, each beginning with its lowest number: after each side comes the one that bounds the
/// same sector at its end, the next clockwise. Directions are compared a little away from the node, so that curves with
/// a common tangent have an order.
std::vector<std::vector<int>> traced_loops(const std::vector<SideOfCurve>& sides);

}  // namespace quadrille::sew
