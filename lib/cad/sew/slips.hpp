#pragma once
// Boundaries of two regions that run along each other with a gap that nobody can mean.

#include <optional>

#include "heal/heal_scale.hpp"
#include "sew/region_distance.hpp"
#include "sew/sew_regions.hpp"

namespace quadrille::sew {

struct Slip {
  int a = 0, b = 0;  ///< the regions
  MeasuredPlace gap;
};

/// The greatest gap that is clearly a slip, a length: a thousandth of the diameter or, if a tolerance was given
/// (`is_asked`), ten times that.
double most_slip_of(const heal::HealScale& scale, bool is_asked);

/// The first curve of the boundary of the whole of which a third or more runs within `most_slip` of the boundary of
/// another region, and no further away than a fiftieth of its length; with the greatest distance there.
std::optional<Slip> find_slip(const Sewn& sewn, double most_slip);

}  // namespace quadrille::sew
