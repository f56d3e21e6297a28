#pragma once
// The field as a page draws it: on each triangle cubic pieces, as few as the drawing at first view needs.
//
// A triangle is divided into m^2 equal parts, and the field is a cubic polynomial on each: its values at the points of
// a lattice of 3 m intervals. The page draws straight lines between k points on each side of a part. m and k are the
// first, of the cheapest, whose drawing deviates from the field by at most a fifth of a pixel at first view.

#include <array>
#include <cstdint>
#include <vector>

#include "draw/field_cells.hpp"
#include "page/page_data.hpp"

namespace quadrille::page {

/// How a triangle is drawn.
struct LatticeForm {
  int parts = 1;  ///< m: 1, 2 or 4
  int lines = 2;  ///< k: 2, 4 or 8
  int intervals() const { return 3 * parts; }
  int num_points() const { return (intervals() + 1) * (intervals() + 2) / 2; }
};

/// What is drawn at the point (s, t) of the unit triangle, of values at the points (i, j) / 3m, row by row from j = 0.
Vec2 drawn_value(LatticeForm form, const std::vector<Vec2>& at_points, double s, double t);

/// Of all triangles, region by region; packed as the page reads it (view/samples.js).
struct FieldSamples {
  std::vector<std::uint8_t> forms;   ///< parts + 8 lines, + 128 if the triangle is curved
  std::vector<std::int32_t> points;  ///< in the frame's units: three corners, or all points of a curved triangle
  std::vector<double> scales;        ///< of u and v of each triangle: its greatest absolute value
  std::vector<std::int16_t> values;  ///< u and v of each point, in units of its scale / 32767
};

/// Cost: about 150 evaluations for each triangle.
FieldSamples field_samples(const draw::RegionFields& regions, const PageFrame& frame);

}  // namespace quadrille::page
