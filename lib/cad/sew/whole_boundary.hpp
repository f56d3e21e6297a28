#pragma once
// The boundary of the regions when they are glued along their interfaces.

#include <vector>

#include "sew/sew_regions.hpp"

namespace quadrille::sew {

/// Closed chains of the curves without partner, each with the whole on its left. After a curve comes the one that
/// bounds the same sector of the whole: the next one in its loop, across interfaces the next one after the partner, and
/// so on.
std::vector<std::vector<CurveId>> whole_boundary(const Sewn& sewn);

/// The regions that are connected by interfaces, by their least number.
std::vector<std::vector<int>> connected_regions(const Sewn& sewn);

}  // namespace quadrille::sew
