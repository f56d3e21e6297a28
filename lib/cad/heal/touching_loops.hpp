#pragma once
// Points at which loops touch: there the boundary is cut apart, so that each loop goes around one side of the point.

#include <vector>

#include "heal/loop.hpp"

namespace quadrille::heal {

/// How near to each other the parts of a boundary are in contact, lengths.
struct ContactTolerance {
  double of_joints = 0;  ///< two joints
  double of_curves = 0;  ///< a joint and a curve that does not end there; the curve is split
};

/// The same boundary with other loops at points of contact: the curve that ends there goes on with the one that bounds
/// the same sector of the face. A hole that touches the outline in a point becomes part of it; two such points, or an
/// outline that touches itself, separate the face into pieces. `loops`: with the face on their left. Where nothing
/// touches, and where curves cross or lie upon each other, they stay. Joints in contact get the same position.
std::vector<Loop> separated_loops(const std::vector<Loop>& loops, const ContactTolerance& tol);

/// For each curve, whether another curve of the loops starts at the same point as it does: the face touches itself.
std::vector<std::vector<bool>> contacts_at_starts(const std::vector<Loop>& loops);

}  // namespace quadrille::heal
