#pragma once
// Where inner curves meet the boundary of their region and each other.

#include <string>
#include <vector>

#include "sew/region.hpp"

namespace quadrille::sew {

/// The joints of the region first, then where inner curves cross or end on the boundary, cross each other, end on each
/// other, and end. Points within `tol` of each other are one node, but joints are never united. Seams of smooth closed
/// curves are no nodes. Throws as embed_curves.
std::vector<Vec2> inner_nodes(const Region& region, const std::vector<heal::LoopCurve>& curves, double tol,
                              const std::string& file);

}  // namespace quadrille::sew
