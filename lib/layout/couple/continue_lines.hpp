#pragma once
// Lines that end on an interface are continued in the field of the other side.

#include <functional>
#include <optional>
#include <vector>

#include "couple/region_layouts.hpp"
#include "couple/side_pairs.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::couple {

/// A line through one region.
struct TracedLine {
  Nurbs spline;
  bool ends_on_boundary = false;
  BoundaryPoint end;  ///< in the region
};

/// A line of one region that starts where a line of a neighbour ends alone.
struct Continuation {
  int region = 0;
  BoundaryPoint start;             ///< in the region
  std::optional<TracedLine> line;  ///< none: it cannot be traced, or is part of another one
};

/// Whether a line that starts at a point of a region's boundary can be inserted into its layout.
using CanInsert = std::function<bool(const graph::Subdivision&, const BoundaryPoint&)>;

/// Those of all lines that end where no line of the other side does. Lines that cross a region in opposite directions,
/// each the nearest to the other and not bent by more than `greatest_bend`, become one, from the start of one to the
/// start of the other; the second one has no line of its own then.
std::vector<Continuation> continuations(const RegionLayouts& regions, CutEnds cuts, const CanInsert& can_insert);

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
