#pragma once
// The contours on which a component of the field vanishes. Each element is cut into small triangles, and the contour is
// a straight segment in each of them.

#include <array>
#include <functional>
#include <vector>

#include "draw/field_cells.hpp"
#include "draw/picture.hpp"
#include "field/evaluate.hpp"

namespace quadrille::draw {

/// A component of the field as a function of the value.
using Component = std::function<double(Vec2 value)>;

struct ContourSegment {
  std::array<Vec2, 2> ends;  ///< pixels
};

/// The sign of the component along a side of an element, as this element has it; s in [0, 1], counter-clockwise.
struct SideSigns {
  bool is_positive = true;           ///< at s = 0
  std::vector<double> roots;         ///< ascending: the sign changes at each
  std::vector<bool> is_significant;  ///< of equal pieces of the side: false where the component is identically zero

  bool is_positive_at(double s) const;
  bool is_significant_at(double s) const;
};

struct ElementContour {
  std::vector<ContourSegment> segments;
  std::array<SideSigns, 3> sides;
};

/// The contour in element `elem`. Ends of segments are exact zeros on the sides of the small triangles, so that those
/// on a side of the element are the roots of its SideSigns. Nothing is drawn where the component is identically zero
/// up to solver errors: below 1e-7 in a whole neighbourhood of 16 pixels within the element. Empty, sides included, if
/// the element is outside the window that the picture shows.
ElementContour element_contour(const Picture& picture, const field::FieldEvaluator& evaluator, int elem,
                               const Component& component);

/// The contour along a side that two elements share, where their signs differ: a component changes its sign across
/// the side where it is discontinuous, or where it vanishes on the side up to rounding. With these segments no line
/// ends at a side. `side` is that of `elem`, `other` the signs of its neighbour.
std::vector<ContourSegment> side_contour(const Picture& picture, const field::FieldEvaluator& evaluator, int elem,
                                         int side, const SideSigns& own, const SideSigns& other);

using Polyline = std::vector<Vec2>;

/// The polylines (pixels) on which `component` of the value vanishes; none in regions where it is identically zero. A
/// line ends only at the boundary, at another line or at such a region.
std::vector<Polyline> zero_contours(const Picture& picture, const field::FieldEvaluator& evaluator,
                                    const Component& component);

/// Draws the contours u = 0 and v = 0 of each region with one legend; jump lines, the part of v = 0 where the cross
/// angle jumps, are dashed.
void draw_zero_contours(Picture& picture, const RegionFields& regions);

}  // namespace quadrille::draw
