#pragma once
// How lines that end on an interface go on in the field of the other side.

#include <functional>
#include <optional>
#include <vector>

#include "couple/interface_chains.hpp"
#include "couple/region_layouts.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::couple {

/// A line through one region.
struct TracedLine {
  Nurbs spline;
  bool ends_on_boundary = false;
  Place end;  ///< in the region
};

/// A line that ends on an interface, where no line of the other side does, and its way on there.
struct Continuation {
  int region = 0;
  Place start;  ///< in the region
  std::optional<TracedLine> line;

  Vec2 start_in(const CadFace& face) const { return curve::point(face.curves[start.curve], start.t); }
  Vec2 end_in(const CadFace& face) const { return curve::point(face.curves[line->end.curve], line->end.t); }
};

/// Whether a line that starts at a place of a region's boundary can be inserted into its layout.
using Admits = std::function<bool(const graph::Subdivision&, const Place&)>;

/// The ways on of all lines that end where no line of the other side does. Lines that cross a region in opposite
/// directions, each the nearest to the other and not bent by more than 0.1 radian, become one, from the end of one to
/// the end of the other; the second one has no way of its own then.
std::vector<Continuation> continuations(const RegionLayouts& regions, CutEnds cuts, const Admits& admits);

}  // namespace quadrille::couple
