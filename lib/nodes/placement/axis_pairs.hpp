#pragma once
// Pairs of irregular nodes on a mirror axis of the face.
//
// A node on an axis stays there as long as its set is symmetric. Two nodes of one index that follow each other on the
// axis repel each other and cannot pass. As a pair they can leave it: turned by a quarter about their middle they are
// mirror images of each other. Like two roots of a real polynomial, which are both real or conjugate, both positions
// are symmetric, and neither is reached from the other by a small movement.

#include <vector>

#include "curve/face_boundary.hpp"
#include "model/critical_points.hpp"
#include "placement/node_symmetry.hpp"

namespace quadrille::placement {

/// One entry for each such pair, with the nodes at their positions after the pair, and its images under `group`, was
/// turned. The two have the same valence and may both move, each is nearer to the other than to any third node, and one
/// of them is_stuck. Pairs without room for the turn have no entry. Quadratic in the number of nodes on axes.
std::vector<CriticalPoints> with_turned_pairs(const curve::FaceBoundary& boundary,
                                              const std::vector<NodeSymmetry>& group, const std::vector<bool>& may_move,
                                              const std::vector<bool>& is_stuck, const CriticalPoints& points);

}  // namespace quadrille::placement
