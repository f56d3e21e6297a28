#include "sizing/metric_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/point_grid.hpp"
#include "base/tolerance.hpp"

namespace quadrille::sizing {
namespace {

constexpr int averaged = 6;          ///< points
constexpr double reach = 1.5;        ///< of the average, over the distance of the last of these
constexpr double same_place = 1e-9;  ///< over the extent of all points
constexpr int points_of_leaf = 8;
constexpr int max_rounds = 200;        ///< in which lengths are reduced
constexpr double least_change = 1e-3;  ///< of a length, after which there is another round

SymmetricTensor logarithm_of(const MetricSample& sample) {
  return tensor_of({-std::log(sample.h1), -std::log(sample.h2), sample.angle});
}

SymmetricTensor exponential(const SymmetricTensor& t) {
  const EigenPair of = eigen_pair(t);
  return tensor_of({std::exp(of.first), std::exp(of.second), of.angle});
}

double extent(const std::vector<MetricSample>& samples) {
  Vec2 low = samples.front().position, high = low;
  for (const MetricSample& sample : samples) {
    low = {std::min(low.x, sample.position.x), std::min(low.y, sample.position.y)};
    high = {std::max(high.x, sample.position.x), std::max(high.y, sample.position.y)};
  }
  return distance(low, high);
}

}  // namespace

/// Halves the points by their medians. The points of a node are order_[begin, end); its middle one parts them.
class MetricField::Tree {
 public:
  explicit Tree(std::vector<Vec2> points)
      : points_(std::move(points)), order_(points_.size()), is_by_x_(points_.size()), part_(points_.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    divide(0, points_.size());
  }

  const std::vector<Vec2>& points() const { return points_; }

  /// The distance from x to the point that is averaged last.
  double distance_of_last(Vec2 x) const {
    std::array<double, averaged> nearest;  // squared, ascending
    nearest.fill(INFINITY);
    search(0, points_.size(), x, nearest.back(), [&](int, double distance2) {
      const auto at = std::ranges::upper_bound(nearest, distance2);
      std::copy_backward(at, nearest.end() - 1, nearest.end());
      *at = distance2;
    });
    const std::size_t last = std::min<std::size_t>(averaged, points_.size()) - 1;
    return std::sqrt(nearest[last]);
  }

  /// visit(point, squared distance) for all points less than a distance away.
  template <class Visit>
  void near(Vec2 x, double radius, const Visit& visit) const {
    const double bound = radius * radius;
    search(0, points_.size(), x, bound, visit);
  }

 private:
  void divide(std::size_t begin, std::size_t end) {
    if (end - begin <= points_of_leaf) return;
    Vec2 low = points_[order_[begin]], high = low;
    for (std::size_t i = begin; i < end; ++i) {
      const Vec2 p = points_[order_[i]];
      low = {std::min(low.x, p.x), std::min(low.y, p.y)}, high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const std::size_t middle = (begin + end) / 2;
    const bool by_x = is_by_x_[middle] = high.x - low.x > high.y - low.y;
    const auto before = [&](int a, int b) { return by_x ? points_[a].x < points_[b].x : points_[a].y < points_[b].y; };
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), before);
    part_[middle] = by_x ? points_[order_[middle]].x : points_[order_[middle]].y;
    divide(begin, middle), divide(middle, end);
  }

  /// visit(point, squared distance) for all points with a squared distance below `bound`, which visits may lower.
  template <class Visit>
  void search(std::size_t begin, std::size_t end, Vec2 x, const double& bound, const Visit& visit) const {
    if (end - begin <= points_of_leaf) {
      for (std::size_t i = begin; i < end; ++i)
        if (const double distance2 = norm2(points_[order_[i]] - x); distance2 < bound) visit(order_[i], distance2);
      return;
    }
    const std::size_t middle = (begin + end) / 2;
    const double beyond = (is_by_x_[middle] ? x.x : x.y) - part_[middle];
    const bool is_low = beyond < 0;
    search(is_low ? begin : middle, is_low ? middle : end, x, bound, visit);
    if (beyond * beyond <= bound) search(is_low ? middle : begin, is_low ? end : middle, x, bound, visit);
  }

  std::vector<Vec2> points_;
  std::vector<int> order_;
  // By middle: the coordinate that parts the points, and its value.
  std::vector<bool> is_by_x_;
  std::vector<double> part_;
};

MetricField::MetricField(const std::vector<MetricSample>& samples, double slope) {
  std::vector<Vec2> positions, places;
  for (const MetricSample& sample : samples) positions.push_back(sample.position);
  const std::vector<int> first = places_of(positions, same_place * extent(samples));
  std::vector<int> number(samples.size(), -1), count;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    int& place = number[first[i]];
    if (place < 0) {
      place = static_cast<int>(places.size());
      places.push_back(positions[i]), count.push_back(0), logarithms_.push_back({0, 0, 0});
    }
    ++count[place], logarithms_[place] += logarithm_of(samples[i]);
  }
  for (std::size_t i = 0; i < places.size(); ++i) logarithms_[i] = (1.0 / count[i]) * logarithms_[i];
  tree_ = std::make_shared<const Tree>(std::move(places));
  limit_growth(slope);
}

/// Directions stay. All lengths of a round are those before it, so that the order of points does not matter.
void MetricField::limit_growth(double slope) {
  const std::vector<Vec2>& points = tree_->points();
  bool is_changed = true;
  for (int round = 0; round < max_rounds && is_changed; ++round) {
    is_changed = false;
    std::vector<SymmetricTensor> roots;
    for (const SymmetricTensor& logarithm : logarithms_) roots.push_back(exponential(logarithm));
    for (std::size_t i = 0; i < points.size(); ++i) {
      EigenPair of = eigen_pair(logarithms_[i]);
      const Vec2 along = unit(of.angle);
      const auto limit = [&](double& logarithm, Vec2 direction, std::size_t other, double growth) {
        const double least = -std::log(1 / norm(roots[other] * direction) + growth);
        is_changed |= least > logarithm + least_change;
        logarithm = std::max(logarithm, least);
      };
      const double radius = (1 + tolerance::tied) * reach * tree_->distance_of_last(points[i]);
      tree_->near(points[i], radius, [&](int other, double distance2) {
        const double growth = slope * std::sqrt(distance2);
        limit(of.first, along, other, growth), limit(of.second, left_of(along), other, growth);
      });
      logarithms_[i] = tensor_of(of);
    }
  }
}

SymmetricTensor MetricField::logarithm(Vec2 x) const {
  if (logarithms_.size() == 1) return logarithms_.front();
  const double radius = reach * tree_->distance_of_last(x);
  SymmetricTensor sum{0, 0, 0};
  double weight = 0;
  tree_->near(x, radius, [&](int point, double distance2) {
    const double inside = 1 - distance2 / (radius * radius);
    weight += inside * inside;
    sum += (inside * inside) * logarithms_[point];
  });
  return (1 / weight) * sum;
}

}  // namespace quadrille::sizing
