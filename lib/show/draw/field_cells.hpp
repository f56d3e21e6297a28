#pragma once
// The field in pixels: coloured cells, zero contours, crosses.

#include <functional>
#include <string>
#include <vector>

#include "draw/contour_lattice.hpp"
#include "draw/picture.hpp"
#include "draw/region_fields.hpp"

namespace quadrille::draw {

/// Paints every element with cells that are refined until `colour` is nearly constant over each or they are a few
/// pixels small. `difference` compares two values: above 1 the cell is split.
void draw_field_cells(Picture& picture, const field::FieldEvaluator& evaluator,
                      const std::function<std::string(Vec2 value)>& colour,
                      const std::function<double(Vec2 a, Vec2 b)>& difference);

using Polyline = std::vector<Vec2>;

/// The polylines (pixels) on which `component` of the value vanishes; none in regions where it is identically zero. A
/// line ends only at the boundary, at another line or at such a region.
std::vector<Polyline> zero_contours(const Picture& picture, const field::FieldEvaluator& evaluator,
                                    const Component& component);

/// Draws the contours u = 0 and v = 0 of each region with one legend; jump lines, the part of v = 0 where the cross
/// angle jumps, are dashed.
void draw_zero_contours(Picture& picture, const RegionFields& regions);

/// Crosses on a lattice of `spacing` pixels, the same for all regions.
void draw_crosses(Picture& picture, const field::FieldEvaluator& evaluator, double spacing);

}  // namespace quadrille::draw
