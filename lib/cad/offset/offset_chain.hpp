#pragma once
// The connected curves at a distance from a chain of walls.
//
// Both ends of each wall's offset curve are cut, or extended straight, where it crosses the next one. At a corner of
// more than OffsetConstants::least_capped_angle they are extended to a straight line across the bisector, at the
// distance from the corner. The ends of a chain that is not closed lie on the neighbouring boundaries; on
// a line of symmetry the chain and its mirror image make a corner, with half of a straight line across it.

#include <vector>

#include "heal/loop.hpp"
#include "offset/offset_profile.hpp"

namespace quadrille::offset {

/// In the order of the chain, each ending where the next one starts; bit for bit, unless on the boundary. Names are
/// those of the walls, with "_offset". Throws ComputeError, with the request and the place, where curves do not cross,
/// or not between their other ends: the distance is too great. Tolerances in diameters of the face.
std::vector<heal::LoopCurve> offset_chain(const CadFace& face, const WallChain& chain, const ChainProfile& profile,
                                          const std::vector<OffsetRequest>& requests);

}  // namespace quadrille::offset
