#include "field/alignment_term.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <optional>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"

namespace quadrille::field {
namespace {

using Complex = std::complex<double>;

constexpr double reach = 6;            ///< widths at which a Gaussian is 2e-16
constexpr double spacing = 0.5;        ///< widths between Gaussians of a row: their sum is smooth to round-off
constexpr double greatest_ratio = 10;  ///< of the lengths of a metric: directions need no more
constexpr double samples_across = 2;   ///< of a metric, in the width of a Gaussian
constexpr double metric_reach = 3;     ///< widths within which samples are averaged
constexpr std::size_t max_points = 200'000;

double squared(double x) { return x * x; }

void add(Alignment& all, const AlignmentPoint& point) {
  if (point.rate == 0) return;
  if (!std::isfinite(point.rate))
    throw FormatError(
        fmt::format("--align: a feature is too strong or too narrow ({:g}): mu is not finite", point.width));
  if (all.size() >= max_points)
    throw FormatError("--align: the features are too narrow for their extent: more than 200,000 Gaussians");
  all.push_back(point);
}

int num_pieces(double length, double width) {
  return std::max(1, static_cast<int>(std::ceil(std::min(length / (spacing * width), max_points + 1.0))));
}

/// A curve of straight pieces, by its length.
class Polyline {
 public:
  explicit Polyline(const std::vector<Vec2>& points) : points_(points), lengths_{0} {
    for (std::size_t i = 1; i < points.size(); ++i)
      lengths_.push_back(lengths_.back() + distance(points[i - 1], points[i]));
  }
  double length() const { return lengths_.back(); }
  Vec2 at(double s) const {
    const auto end = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, s);
    const auto i = end - lengths_.begin();
    const double piece = lengths_[i] - lengths_[i - 1];
    return piece > 0 ? points_[i - 1] + (s - lengths_[i - 1]) / piece * (points_[i] - points_[i - 1]) : points_[i];
  }

 private:
  const std::vector<Vec2>& points_;
  std::vector<double> lengths_;
};

/// Each Gaussian has the direction of the curve over its share of the length.
void add_curve(const AlignmentFeature& feature, double rate, Alignment& all) {
  const Polyline curve(feature.points);
  const int count = num_pieces(curve.length(), feature.width);
  const double step = curve.length() / count, weight = step / (std::sqrt(pi) * feature.width);
  for (int i = 0; i < count; ++i) {
    const Vec2 along = curve.at((i + 1) * step) - curve.at(i * step);
    add(all, {curve.at((i + 0.5) * step), feature.width, weight * rate, feature.angle.value_or(angle_of(along))});
  }
}

void add_box(const AlignmentBox& box, double rate, Alignment& all) {
  const Vec2 size = box.high - box.low;
  const int columns = num_pieces(size.x, box.width), rows = num_pieces(size.y, box.width);
  const Vec2 step{size.x / columns, size.y / rows};
  const double weight = step.x * step.y / (pi * squared(box.width));
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      add(all, {box.low + Vec2{(i + 0.5) * step.x, (j + 0.5) * step.y}, box.width, weight * rate, box.angle});
}

/// The trace-free part of the logarithm of a metric, as a complex number of twice the angle.
Complex trace_free_part(const MetricSample& sample) {
  return std::polar(1.0, 2 * sample.angle) * std::log(sample.h1 / sample.h2);
}

/// Sorts points into squares of a grid, so that those near a place are found at once.
class PointGrid {
 public:
  PointGrid(const std::vector<MetricSample>& samples, double cell) : samples_(samples), cell_(cell) {
    for (std::size_t i = 0; i < samples.size(); ++i) cells_[key(samples[i].position)].push_back(static_cast<int>(i));
  }
  /// Visits the samples within a cell's width of x, and some others.
  template <class Visit>
  void near(Vec2 x, const Visit& visit) const {
    const auto [column, row] = key(x);
    for (long j = row - 1; j <= row + 1; ++j)
      for (long i = column - 1; i <= column + 1; ++i)
        if (const auto found = cells_.find({i, j}); found != cells_.end())
          for (const int k : found->second) visit(samples_[k]);
  }

 private:
  std::pair<long, long> key(Vec2 x) const {
    return {static_cast<long>(std::floor(x.x / cell_)), static_cast<long>(std::floor(x.y / cell_))};
  }

  const std::vector<MetricSample>& samples_;
  double cell_;
  std::map<std::pair<long, long>, std::vector<int>> cells_;
};

/// The mean trace-free part near a point; none where there are no samples.
std::optional<Complex> mean_trace_free_part(const PointGrid& grid, Vec2 x, double width) {
  double weight = 0;
  Complex sum = 0;
  grid.near(x, [&](const MetricSample& sample) {
    const double of = std::exp(-squared(distance(sample.position, x) / width));
    weight += of, sum += of * trace_free_part(sample);
  });
  return weight > 0.5 ? std::optional(sum / weight) : std::nullopt;
}

void add_metric(const std::vector<MetricSample>& samples, double strength, double diameter, Alignment& all) {
  if (samples.empty()) return;
  Vec2 low = samples.front().position, high = low;
  for (const MetricSample& sample : samples) {
    low = {std::min(low.x, sample.position.x), std::min(low.y, sample.position.y)};
    high = {std::max(high.x, sample.position.x), std::max(high.y, sample.position.y)};
  }
  const double least = 1e-3 * diameter;
  const double area = std::max(high.x - low.x, least) * std::max(high.y - low.y, least);
  const double width = std::max(samples_across * std::sqrt(area / static_cast<double>(samples.size())), least);
  const double step = spacing * width, rate = squared(strength / width) * squared(spacing) / pi;
  const PointGrid grid(samples, metric_reach * width);
  for (double y = low.y; y < high.y + step; y += step)
    for (double x = low.x; x < high.x + step; x += step) {
      const std::optional<Complex> mean = mean_trace_free_part(grid, {x, y}, width);
      if (!mean) continue;
      const double anisotropy = std::tanh(std::min(std::abs(*mean), std::log(greatest_ratio)) / 2);
      add(all, {{x, y}, width, rate * squared(anisotropy), std::arg(*mean) / 2});
    }
}

}  // namespace

Alignment make_alignment(const AlignmentRequest& request, double strength, double diameter) {
  Alignment all;
  for (const AlignmentFeature& feature : request.features) {
    const double rate = squared(strength * feature.strength / feature.width);
    if (feature.points.size() == 1)
      add(all, {feature.points.front(), feature.width, rate, feature.angle.value_or(0)});
    else
      add_curve(feature, rate, all);
  }
  for (const AlignmentBox& box : request.boxes) add_box(box, squared(strength * box.strength / box.width), all);
  add_metric(request.metric, strength, diameter, all);
  return all;
}

AlignmentTerm::AlignmentTerm(const Alignment& alignment) : alignment_(alignment) {
  if (alignment.empty()) return;
  constexpr int most_cells = 1000;  // in each direction
  Vec2 high = low_ = alignment.front().position;
  double width = 0;
  for (const AlignmentPoint& point : alignment) {
    direction_.push_back(unit(4 * point.angle));
    low_ = {std::min(low_.x, point.position.x), std::min(low_.y, point.position.y)};
    high = {std::max(high.x, point.position.x), std::max(high.y, point.position.y)};
    width = std::max(width, point.width);
  }
  const Vec2 size = high - low_;
  cell_ = std::max({reach * width, size.x / most_cells, size.y / most_cells});
  columns_ = static_cast<int>(size.x / cell_) + 1, rows_ = static_cast<int>(size.y / cell_) + 1;
  cells_.resize(static_cast<std::size_t>(columns_) * rows_);
  for (std::size_t k = 0; k < alignment.size(); ++k) {
    const Vec2 offset = (alignment[k].position - low_) / cell_;
    cells_[static_cast<int>(offset.x) + columns_ * static_cast<int>(offset.y)].push_back(static_cast<int>(k));
  }
}

template <class Visit>
void AlignmentTerm::near(Vec2 centre, double radius, const Visit& visit) const {
  const auto range = [&](double from, int count) {
    const double first = std::floor((from - radius) / cell_) - 1, last = std::floor((from + radius) / cell_) + 1;
    return std::pair(static_cast<int>(std::clamp(first, 0.0, 1.0 * count)),
                     static_cast<int>(std::clamp(last, -1.0, count - 1.0)));
  };
  const auto [left, right] = range(centre.x - low_.x, columns_);
  const auto [bottom, top] = range(centre.y - low_.y, rows_);
  for (int j = bottom; j <= top; ++j)
    for (int i = left; i <= right; ++i)
      for (const int k : cells_[i + columns_ * j])
        if (distance(centre, alignment_[k].position) < radius + reach * alignment_[k].width) visit(k);
}

AlignmentTerm::Value AlignmentTerm::at(Vec2 x) const {
  Value value;
  near(x, 0, [&](int k) {
    const AlignmentPoint& point = alignment_[k];
    const double rate = point.rate * std::exp(-squared(distance(x, point.position) / point.width));
    value.rate += rate;
    value.target += rate * direction_[k];
    value.pull += rate * squared(point.width) * direction_[k];
  });
  return value;
}

bool AlignmentTerm::acts_in(Vec2 centre, double radius) const {
  bool acts = false;
  near(centre, radius, [&](int) { acts = true; });
  return acts;
}

}  // namespace quadrille::field
