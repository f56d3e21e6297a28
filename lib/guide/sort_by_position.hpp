#pragma once
// An order of points that rounding errors do not change: by x, then y.

#include <algorithm>
#include <vector>

#include "base/tie_classes.hpp"

namespace quadrille::guide {

/// Sorts by the position that `at` gives, x values equal within `tol` counting as equal. Tolerances are no ordering:
/// the points are put into columns of equal x first, then each column is sorted by y.
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
