#pragma once
// Lines that end on an interface are continued in the field of the other side.

#include "couple/region_layouts.hpp"

namespace quadrille::couple {

/// Continues each line that ends on an interface where no line of the other side does: it is traced through the field
/// there, up to the opposite side of the face that it enters, where it ends in a T-junction, or on the boundary. A line
/// that would leave the face by another side is not continued. Cuts, whose places are arbitrary, are left out unless
/// `with_cuts`. Returns the number of lines.
int continue_lines(RegionLayouts& regions, bool with_cuts);

/// Removes the cuts of regions that other lines cross. Returns their number.
int remove_needless_cuts(RegionLayouts& regions);

}  // namespace quadrille::couple
