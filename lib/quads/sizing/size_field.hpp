#pragma once
// The prescribed length of element edges at every position.
//
//   h(x) = min( greatest, min over sources of h_source + ln(growth) |x - source| ),
//
// so that of consecutive elements each is at most `growth` times as long as its neighbour: h grows by ln(growth) for
// each unit of length (n elements of an h = s x end where x = exp(s n)). Distances are straight, through holes too.
// On a curved face x is the point in space: sizes, sources and distances are those of space, also straight. h e^-lambda
// is the length in the chart, where all the rest works.

#include <memory>
#include <vector>

#include "base/symmetric_tensor.hpp"
#include "base/vec2.hpp"
#include "model/size_sources.hpp"
#include "sizing/chart_scale.hpp"

namespace quadrille::sizing {

/// A source along a straight segment, its size linear from end to end, or, of planar faces, along a circular arc: a
/// piece of a boundary curve. Positions are those of SizeSources.
struct SizeSegment {
  Vec3 a, b;
  double size_a = 0, size_b = 0;
  int region = -1;  ///< acts in this region alone; -1: everywhere
  /// > 0: an arc about `centre` of at most half a turn, counter-clockwise from a to b, of the size `size_a` = `size_b`.
  double radius = 0;
  Vec2 centre = {};

  bool is_arc() const { return radius > 0; }
};

class MetricField;

/// The square root of a metric: the tensor `stretch`, of determinant 1, over the length `size` = sqrt(h1 h2).
struct DirectedSize {
  double size = 0;
  SymmetricTensor stretch = {};

  double along(Vec2 unit_direction) const { return size / norm(stretch * unit_direction); }
  double least() const { return stretch == SymmetricTensor{} ? size : size / eigen_pair(stretch).first; }
};

/// e^(4 i angle), angle that of h1 or h2, times ((r - 1) / (r + 1))^2, r the ratio of these: 0 where they are equal.
Vec2 direction_of(const DirectedSize& size);

class SizeField {
 public:
  static constexpr double default_growth = 1.2;
  static constexpr int default_per_curve = 4;  ///< elements along each boundary curve in a far field

  /// A constant size. `greatest` > 0.
  explicit SizeField(double greatest);
  /// Sources of `greatest` or more have no effect. `growth` > 1. Throws UsageError for sizes that are not positive.
  SizeField(double greatest, const SizeSources& sources, const std::vector<SizeSegment>& segments, double growth);

  /// These sources and more, with the same growth; that of a constant size is the default.
  SizeField with(const std::vector<SizeSegment>& segments) const;

  /// The same sizes in space, as lengths in the chart of this scale; null: the face is planar.
  SizeField in_chart(std::shared_ptr<const ChartScale> scale) const;
  const std::shared_ptr<const ChartScale>& scale() const { return scale_; }

  /// Prescribed edge length at x, relative to face.origin, in a region; -1: on an interface, where the sources of both
  /// sides act, or in a face of one region. Cost: logarithmic in the number of sources.
  /// With a metric that is sqrt(h1 h2).
  double at(Vec2 x, int region = -1) const { return directed(x, region).size; }
  /// The same with the metric, which is isotropic where none is prescribed.
  DirectedSize directed(Vec2 x, int region = -1) const;
  /// Of edges in a direction, which does not count without a metric.
  double along(Vec2 unit_direction, Vec2 x, int region = -1) const {
    return metric_ ? directed(x, region).along(unit_direction) : at(x, region);
  }
  double greatest() const { return scale_ ? greatest_ / scale_->least() : greatest_; }
  double greatest_in_space() const { return greatest_; }
  /// The greatest that any source leaves at x: all are of one length in space.
  double greatest_at(Vec2 x) const { return scale_ ? greatest_ / scale_->at(x).scale : greatest_; }
  /// Bound of |dh / dx|: ln(growth), and what the scale of a chart adds; 0 if the size is constant.
  double slope() const { return scale_ ? slope_ + greatest_ * scale_->greatest_gradient() : slope_; }
  bool is_uniform() const { return !sources_ && !metric_ && !scale_; }
  bool has_metric() const { return metric_ != nullptr; }

 private:
  struct Sources;
  void set_sources(Sources sources, double slope);

  double greatest_ = 0, slope_ = 0;
  std::shared_ptr<const Sources> sources_;
  std::shared_ptr<const ChartScale> scale_;
  std::shared_ptr<const MetricField> metric_;
};

}  // namespace quadrille::sizing
