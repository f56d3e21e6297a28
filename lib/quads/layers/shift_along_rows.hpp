#pragma once
// Moves the nodes of a block along its rows.

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/vec2.hpp"

namespace quadrille::layers {

// Cubic Hermite interpolation of values at 0, 1, 2, ..., with the slopes of the parabolas through three of them.

/// The slope at the integer i. At least two values.
template <class T>
T index_slope(const std::vector<T>& values, int i) {
  const int last = static_cast<int>(values.size()) - 1;
  if (last == 1) return values[1] - values[0];
  if (i == 0) return 2 * (values[1] - values[0]) - (values[2] - values[0]) / 2;
  if (i == last) return 2 * (values[last] - values[last - 1]) - (values[last] - values[last - 2]) / 2;
  return (values[i + 1] - values[i - 1]) / 2;
}

template <class T>
struct IndexCubic {
  T value, slope, bend;  ///< and its first and second derivative
};

/// The second derivative in piece k at its end (t = 1) or beginning (0), or between.
template <class T>
T index_bend(const std::vector<T>& values, int k, double t) {
  return (6 - 12 * t) * (values[k + 1] - values[k]) + (6 * t - 4) * index_slope(values, k) +
         (6 * t - 2) * index_slope(values, k + 1);
}

/// At x; beyond both ends the first and the last piece continue. At an integer the second derivative, which jumps
/// there, is the mean of both: that of the values in reverse order.
template <class T>
IndexCubic<T> index_cubic(const std::vector<T>& values, double x) {
  const int k = std::clamp(static_cast<int>(std::floor(x)), 0, static_cast<int>(values.size()) - 2);
  const double t = x - k, r = 1 - t;
  const T a = index_slope(values, k), b = index_slope(values, k + 1), rise = values[k + 1] - values[k];
  const T bend = index_bend(values, k, t);
  return {r * r * (1 + 2 * t) * values[k] + t * t * (1 + 2 * r) * values[k + 1] + t * r * (r * a - t * b),
          6 * t * r * rise + r * (1 - 3 * t) * a + t * (3 * t - 2) * b,
          t == 0 && k > 0 ? (bend + index_bend(values, k - 1, 1)) / 2 : bend};
}

/// By row and column of the vertices of a block: how far a vertex moves along its row, in intervals of the row.
using RowShifts = std::vector<std::vector<double>>;

/// Nodes of elements of this order in rows of `width` nodes, positions or parameters in the block, after the shifts.
/// Nodes between vertices move with these; those of the first and the last row, and of both ends of each row, stay.
/// Nodes do not move exactly along the curve of their row: their change is that of an interpolation of its vertices.
std::vector<Vec2> shifted_along_rows(const std::vector<Vec2>& nodes, int width, int order, const RowShifts& shifts);

}  // namespace quadrille::layers
