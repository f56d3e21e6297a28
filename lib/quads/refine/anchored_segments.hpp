#pragma once
// The segments of a chord between the anchors at which an element must end.

#include <functional>
#include <vector>

#include "refine/anchors.hpp"
#include "sizing/spacing.hpp"

namespace quadrille::refine {

struct AnchoredSegments {
  std::vector<Anchor> anchors;  ///< ascending
  std::vector<int> required;    ///< numbers of anchors, ascending: the inner ends of the segments
  sizing::Segments segments;    ///< positions v in [0, 1]: the fraction of the chord's elements before them
};

/// Makes an anchor an end of segments; nothing changes if it is one already. The count of both parts of the segment
/// that it cuts is reset to one element: the segment may have needed its count only because it contained the break.
void require_anchor(AnchoredSegments& anchored, int anchor);

/// Moves all breaks, their anchors and the ends of the segments to the positions that `position` returns.
void move_breaks(AnchoredSegments& anchored, const std::function<double(const Break&)>& position);

}  // namespace quadrille::refine
