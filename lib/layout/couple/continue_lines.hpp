#pragma once
// Lines that end on an interface are continued in the field of the other side.

#include "couple/region_layouts.hpp"
#include "couple/side_pairs.hpp"

namespace quadrille::couple {

/// Where continued lines end in a region.
enum class ContinueTo {
  first_line,  ///< on the first line that is there already: integer lengths then decide with which lines they merge
  boundary     ///< on the boundary of the region, across all lines: more blocks, which follow the field
};

/// Continues each line that ends on an interface where no line of the other side does: it is traced through the field
/// there, up to the opposite side of the face that it enters, where it ends in a T-junction, or on the boundary;
/// with ContinueTo::boundary through all faces whose opposite side it reaches. Lines that are continued at the same
/// time cross each other, whichever comes first. A line that would leave a face by another side is not continued.
/// Returns the number of lines.
int continue_lines(RegionLayouts& regions, CutEnds cuts, ContinueTo limit);

/// Removes the cuts of regions that other lines cross. Returns their number.
int remove_needless_cuts(RegionLayouts& regions);

}  // namespace quadrille::couple
