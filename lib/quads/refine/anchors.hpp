#pragma once
// Positions inside the sides of a chord at which elements should end, because a side is not smooth there.
//
// A break is a point of one arc (a joint, a jump of curvature) that no element should straddle. Breaks of different
// arcs opposite each other have one common anchor: the same line across the chord passes through all of them.

#include <vector>

namespace quadrille::refine {

/// A break of one arc of a chord.
struct Break {
  double u = 0;         ///< the chord's parameter there
  double fraction = 0;  ///< of the arc's own length, in its own direction
  int arc = 0;          ///< position in the chord
};

struct Anchor {
  double u = 0;               ///< mean of the breaks
  std::vector<Break> breaks;  ///< at most one for each arc
};

/// Sorted by u. Breaks are grouped if their neighbours in u are nearer than `reach`, or than reach / 2, reach / 4, ...
/// if this would group two breaks of one arc, which must differ in u.
std::vector<Anchor> find_anchors(std::vector<Break> breaks, double reach);

}  // namespace quadrille::refine
