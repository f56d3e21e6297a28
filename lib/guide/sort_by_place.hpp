#pragma once
// A sequence of points that rounding errors do not change: by x, then y.

#include <algorithm>
#include <vector>

namespace quadrille::guide {

/// Sorts by the position that `at` gives, x values equal within `tol` counting as equal. Tolerances are no ordering:
/// the points are put into columns of equal x first, then each column is sorted by y.
template <typename Point, typename At>
void sort_by_place(std::vector<Point>& points, double tol, const At& at) {
  const auto by_x = [&](const Point& a, const Point& b) { return at(a).x < at(b).x; };
  const auto by_y = [&](const Point& a, const Point& b) { return at(a).y < at(b).y; };
  std::stable_sort(points.begin(), points.end(), by_x);
  for (auto first = points.begin(); first != points.end();) {
    auto last = first + 1;
    while (last != points.end() && at(*last).x - at(*(last - 1)).x <= tol) ++last;
    std::stable_sort(first, last, by_y);
    first = last;
  }
}

}  // namespace quadrille::guide
