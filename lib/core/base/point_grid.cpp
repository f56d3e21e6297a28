#include "base/point_grid.hpp"

#include <utility>

#include "base/disjoint_sets.hpp"

namespace quadrille {
namespace {

constexpr double margin = 1e-9;      // of a cell's size: points on an edge of two cells may be counted to either
constexpr int most_cells = 1 << 20;  // along each side

// Rounded down; `least` for NaN.
int bounded(double value, int least, int most) {
  return value > least ? static_cast<int>(std::floor(std::min<double>(value, most))) : least;
}

}  // namespace

PointGrid::PointGrid(std::vector<Vec2> points) : points_(std::move(points)) {
  Vec2 high;
  if (!points_.empty()) low_ = high = points_.front();
  for (const Vec2 p : points_) {
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double width = high.x - low_.x, height = high.y - low_.y, count = static_cast<double>(points_.size());
  // As many cells as points, also where these lie on one line.
  const double share = 1 / std::max(count, 1.0);
  size_ = std::max({std::sqrt(share * width * height), share * width, share * height});
  if (!(size_ > 0) || !std::isfinite(size_)) size_ = 1;
  columns_ = bounded(width / size_, 0, most_cells - 1) + 1;
  rows_ = bounded(height / size_, 0, most_cells - 1) + 1;
  const auto cell_number = [&](Vec2 p) {
    const Cell cell = cell_of(p);
    return std::clamp(cell.j, 0, rows_ - 1) * columns_ + std::clamp(cell.i, 0, columns_ - 1);
  };
  offsets_.assign(static_cast<std::size_t>(columns_) * rows_ + 1, 0);
  for (const Vec2 p : points_) ++offsets_[cell_number(p) + 1];
  for (std::size_t c = 1; c < offsets_.size(); ++c) offsets_[c] += offsets_[c - 1];
  values_.resize(points_.size());
  std::vector<int> next(offsets_.begin(), offsets_.end() - 1);
  for (int n = 0; n < static_cast<int>(points_.size()); ++n) values_[next[cell_number(points_[n])]++] = n;
}

PointGrid::Cell PointGrid::cell_of(Vec2 x) const {
  return {bounded((x.x - low_.x) / size_, -most_cells, 2 * most_cells),
          bounded((x.y - low_.y) / size_, -most_cells, 2 * most_cells)};
}

double PointGrid::inner_distance(Vec2 x, Cell cell, int ring) const {
  const Vec2 corner = low_ + size_ * Vec2{static_cast<double>(cell.i), static_cast<double>(cell.j)};
  const double inside = std::min({x.x - corner.x, corner.x + size_ - x.x, x.y - corner.y, corner.y + size_ - x.y});
  return inside + (ring - margin) * size_;
}

std::vector<int> places_of(const std::vector<Vec2>& points, double same) {
  DisjointSets places(points.size());
  const PointGrid grid(points);
  for (int i = 0; i < static_cast<int>(points.size()); ++i) {
    const Vec2 x = points[i];
    grid.visit_box(x - Vec2{same, same}, x + Vec2{same, same}, [&](int other) {
      if (other < i && distance(points[other], x) <= same) places.unite(other, i);
    });
  }
  std::vector<int> result;
  for (int i = 0; i < static_cast<int>(points.size()); ++i) result.push_back(places.find(i));
  return result;
}

}  // namespace quadrille
