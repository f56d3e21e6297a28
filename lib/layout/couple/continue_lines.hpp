#pragma once
// Lines that end on an interface are continued in the field of the other side.

#include "couple/interface_chains.hpp"
#include "couple/region_layouts.hpp"

namespace quadrille::couple {

/// How far lines are continued in a region.
enum class Reach {
  first_line,  ///< to the first line that is there already: integer lengths then decide with which lines they unite
  region       ///< across all lines to the boundary of the region: more blocks, which follow the field
};

/// Continues each line that ends on an interface where no line of the other side does: it is traced through the field
/// there, up to the opposite side of the face that it enters, where it ends in a T-junction, or on the boundary;
/// with Reach::region through all faces whose opposite side it reaches. Lines that are continued at the same time cross
/// each other, whichever comes first. A line that would leave a face by another side is not continued. Returns the
/// number of lines.
int continue_lines(RegionLayouts& regions, CutEnds cuts, Reach reach);

/// Removes the cuts of regions that other lines cross. Returns their number.
int remove_needless_cuts(RegionLayouts& regions);

}  // namespace quadrille::couple
