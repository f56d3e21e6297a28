#pragma once
// Corners at ties: within 2 degrees of 45 + 90 k degrees two valences are equally good, and the field close to the
// corner decides nothing (lib/method.md §3). All that follows takes the angle of the tie itself, so that 44.98 and 45
// degrees get one layout.

#include <vector>

#include "curve/symmetry.hpp"
#include "model/cad_face.hpp"

namespace quadrille::ties {

struct Tie {
  int joint = 0;
  double angle = 0;  ///< of the tie, radians
  int smaller = 0;   ///< the smaller of both valences; 0 is no choice, because no block fits
};

/// The ties of a face. A *unit* has the ties that rotations of the face map onto each other, an *orbit* those that any
/// isometry does: one unit, or two that are mirror images.
struct TieOrbits {
  std::vector<Tie> ties;                 ///< in the order of the joints
  std::vector<std::vector<int>> units;   ///< of ties with a choice
  std::vector<std::vector<int>> orbits;  ///< of units
  std::vector<int> unit2orbit;
};

/// Isometries are those within a thousandth of the diameter: a symmetric part whose chamfers were drawn at 44.98
/// degrees is decided like one with 45.
TieOrbits tie_orbits(const CadFace& face);

/// Pairs of orbits with ties at both ends of a chamfer: the shorter of the two curves at a tie leads to the other. Each
/// pair once, ascending.
std::vector<std::vector<int>> chamfers(const CadFace& face, const TieOrbits& ties);

}  // namespace quadrille::ties
