#pragma once
// The ends of intervals on opposite sides of a block, and their positions relative to each other.

#include <vector>

#include "growth/growth_input.hpp"

namespace quadrille::growth {

/// An end of an interval and its position along the side: 0 and 1 where the layers of both sides end, if they have
/// equally many, else at the nodes.
struct RelativeEnd {
  int end = 0;          ///< its number on the arc
  double position = 0;  ///< by the chord's parameter
  double slope = 0;     ///< of the position by the arc's own fraction
};

/// A side of a block, in the direction of its opposite side.
struct AlignedSide {
  const sizing::ArcParameter* parameter = nullptr;
  int arc = 0, count = 0;
  bool is_reversed = false;
  double low = 0, high = 1;  ///< chord's parameters of the positions 0 and 1

  RelativeEnd at(const sizing::ArcDivisions& divisions, int i) const;
};

struct OppositeSides {
  AlignedSide a, b;
  double slenderness = 0;  ///< mean length of both over their distance
};

/// Both pairs of sides of every block; a block that touches itself has none.
std::vector<OppositeSides> opposite_arcs(const GrowthInput& input, const sizing::ArcDivisions& divisions);

}  // namespace quadrille::growth
