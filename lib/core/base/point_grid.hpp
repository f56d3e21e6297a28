#pragma once
// Points of the plane in a grid of cells, to find those near a position without looking at all of them.

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/vec2.hpp"

namespace quadrille {

class PointGrid {
 public:
  explicit PointGrid(std::vector<Vec2> points);

  const std::vector<Vec2>& points() const { return points_; }

  /// A point by its number, -1 if none counts, and its squared distance.
  struct Nearest {
    int point = -1;
    double distance2 = std::numeric_limits<double>::infinity();
  };

  /// The point nearest to x for which counts(number) holds; the lowest number if several are equally near.
  template <typename Counts>
  Nearest nearest(Vec2 x, const Counts& counts) const;

  /// Calls visit(number) for every point in the closed rectangle, and for some beside it.
  template <typename Visit>
  void visit_box(Vec2 low, Vec2 high, const Visit& visit) const;

 private:
  /// Column and row of the cell that contains x; outside the grid if x is, at most one more than the farthest ring that
  /// is ever searched.
  struct Cell {
    int i = 0, j = 0;
  };
  Cell cell_of(Vec2 x) const;
  /// The distance from x to the edge of the square of cells up to `ring` from `cell`, its own; less by round-off.
  double inner_distance(Vec2 x, Cell cell, int ring) const;

  template <typename Visit>
  void visit_row(int j, int first, int last, const Visit& visit) const {
    if (j < 0 || j >= rows_) return;
    first = std::max(first, 0), last = std::min(last, columns_ - 1);
    if (first > last) return;
    for (int k = offsets_[j * columns_ + first]; k < offsets_[j * columns_ + last + 1]; ++k) visit(values_[k]);
  }

  std::vector<Vec2> points_;
  Vec2 low_;
  double size_ = 1;  // of a cell, which is a square
  int columns_ = 1, rows_ = 1;
  std::vector<int> offsets_, values_;  // of each cell, its points in ascending order
};

/// For each point the lowest number of those in its place, its own if it is alone: points within `same`, a length, of
/// each other are in one place.
std::vector<int> places_of(const std::vector<Vec2>& points, double same);

template <typename Counts>
PointGrid::Nearest PointGrid::nearest(Vec2 x, const Counts& counts) const {
  Nearest best;
  if (!std::isfinite(x.x) || !std::isfinite(x.y)) return best;
  const auto look_at = [&](int n) {
    const double distance2 = norm2(x - points_[n]);
    const bool is_better = distance2 < best.distance2 || (distance2 == best.distance2 && n < best.point);
    if (is_better && counts(n)) best = {n, distance2};
  };
  const Cell cell = cell_of(x);
  // No cell of the grid lies farther out than this ring.
  const int last = std::max({cell.i, columns_ - 1 - cell.i, cell.j, rows_ - 1 - cell.j});
  for (int ring = 0; ring <= last; ++ring) {
    if (ring > 0 && best.point >= 0) {
      const double searched = inner_distance(x, cell, ring - 1);
      if (searched > 0 && best.distance2 < searched * searched) break;
    }
    visit_row(cell.j - ring, cell.i - ring, cell.i + ring, look_at);
    for (int j = std::max(cell.j - ring + 1, 0); j < std::min(cell.j + ring, rows_); ++j) {
      visit_row(j, cell.i - ring, cell.i - ring, look_at);
      visit_row(j, cell.i + ring, cell.i + ring, look_at);
    }
    if (ring > 0) visit_row(cell.j + ring, cell.i - ring, cell.i + ring, look_at);
  }
  return best;
}

template <typename Visit>
void PointGrid::visit_box(Vec2 low, Vec2 high, const Visit& visit) const {
  const Cell first = cell_of(low), last = cell_of(high);
  for (int j = std::max(first.j, 0); j <= std::min(last.j, rows_ - 1); ++j) visit_row(j, first.i, last.i, visit);
}

}  // namespace quadrille
