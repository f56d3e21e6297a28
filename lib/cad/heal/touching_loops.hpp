#pragma once
// Points at which loops touch: there the boundary is cut apart, so that each loop goes around one side of the point.

#include <vector>

#include "heal/raw_face.hpp"

namespace quadrille::heal {

/// How near to each other the parts of a boundary are in contact, lengths.
struct ContactTolerance {
  double of_joints = 0;  ///< two joints
  double of_curves = 0;  ///< a joint and a curve that does not end there; the curve is split
};

/// Two parts of the boundary that run along each other in opposite directions, with no width of the face between them.
struct CommonLine {
  int edge_a = 0, edge_b = 0;  ///< in the file
  Vec2 start, end;
  double length = 0;
};

/// The same boundary with other loops at points of contact: the curve that ends there goes on with the one that bounds
/// the same sector of the face. A hole that touches the outline in a point becomes part of it; two such points, or an
/// outline that touches itself, separate the face into pieces. `loops`: with the face on their left. Where nothing
/// touches, and where curves cross, they stay; curves that lie upon each other stay too, unless `common` is given: then
/// both are left out and added to it, so that a hole beside an outline becomes a notch. Joints in contact get the same
/// position.
std::vector<Loop> separated_loops(const std::vector<Loop>& loops, const ContactTolerance& tol,
                                  std::vector<CommonLine>* common = nullptr);

/// For each curve, whether another curve of the loops starts at the same point as it does: the face touches itself.
std::vector<std::vector<bool>> contacts_at_starts(const std::vector<Loop>& loops);

}  // namespace quadrille::heal
