#pragma once
// Sorts points by x, then y, in an order that does not depend on rounding errors.

#include <algorithm>
#include <vector>

#include "base/tolerance.hpp"

namespace quadrille::guide {

/// Sorts by the position at(point), with x values equal within `tol` counted as equal. Comparison with a tolerance is
/// not an ordering, so the points are divided into columns of equal x first, and each column is then sorted by y.
template <typename Point, typename At>
void sort_by_position(std::vector<Point>& points, double tol, const At& at) {
  const auto x_of = [&](const Point& a) { return at(a).x; };
  const auto by_x = [&](const Point& a, const Point& b) { return at(a).x < at(b).x; };
  const auto by_y = [&](const Point& a, const Point& b) { return at(a).y < at(b).y; };
  std::stable_sort(points.begin(), points.end(), by_x);
  for (auto first = points.begin(); first != points.end();) {
    const auto last = end_of_chained_ties(first, points.end(), tol, x_of);
    std::stable_sort(first, last, by_y);
    first = last;
  }
}

}  // namespace quadrille::guide
