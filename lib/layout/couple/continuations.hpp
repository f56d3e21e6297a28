#pragma once
// Continuations of lines that end on an interface, in the field of the other side.

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

}  // namespace quadrille::couple
