#pragma once
// Lines that end on an interface near a line of the other side are bent to meet it.

#include "couple/region_layouts.hpp"

namespace quadrille::couple {

/// Two ends on both sides of an interface meet if each is the nearest one to the other and their distance is less than
/// a third of that to the next end on either side, or no line is bent by more than 0.1 radian: in the middle between
/// them, or at the one that cannot move (a corner, or an irregular point). Returns the number of pairs that meet.
int meet_stations(RegionLayouts& regions);

}  // namespace quadrille::couple
