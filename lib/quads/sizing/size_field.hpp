#pragma once
// The prescribed length of element edges at every position.
//
//   h(x) = min( greatest, min over sources of h_source + ln(growth) |x - source| ),
//
// so that of consecutive elements each is at most `growth` times as long as its neighbour: h grows by ln(growth) for
// each unit of length (n elements of an h = s x end where x = exp(s n)). Distances are straight, through holes too.
// On a curved face these are lengths in space, and h e^-lambda is what they are in the chart, where all the rest works;
// distances from sources are those in the chart.

#include <memory>
#include <vector>

#include "base/vec2.hpp"
#include "model/size_sources.hpp"
#include "sizing/chart_scale.hpp"

namespace quadrille::sizing {

/// A source along a straight segment, its size linear from end to end, or along a circular arc: a piece of a boundary
/// curve.
struct SizeSegment {
  Vec2 a, b;
  double size_a = 0, size_b = 0;
  int region = -1;  ///< acts in this region alone; -1: everywhere
  /// > 0: an arc about `centre` of at most half a turn, counter-clockwise from a to b, of the size `size_a` = `size_b`.
  double radius = 0;
  Vec2 centre = {};
};

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

  /// The same sizes, as lengths in the chart of this scale; null: the face is planar.
  SizeField in_chart(std::shared_ptr<const ChartScale> scale) const;

  /// Prescribed edge length at x, relative to face.origin, in a region; -1: on an interface, where the sources of both
  /// sides act, or in a face of one region. Cost: logarithmic in the number of sources.
  double at(Vec2 x, int region = -1) const;
  double greatest() const { return scale_ ? greatest_ / scale_->least() : greatest_; }
  /// The greatest that any source leaves at x: all are of one length in space.
  double greatest_at(Vec2 x) const { return scale_ ? greatest_ / scale_->at(x) : greatest_; }
  /// Bound of |dh / dx|: ln(growth), and what the scale of a chart adds; 0 if the size is constant.
  double slope() const { return scale_ ? slope_ + greatest() * scale_->greatest_gradient() : slope_; }
  bool is_uniform() const { return !sources_ && !scale_; }

 private:
  struct Sources;
  void set_sources(Sources sources, double slope);

  double greatest_ = 0, slope_ = 0;
  std::shared_ptr<const Sources> sources_;
  std::shared_ptr<const ChartScale> scale_;
};

}  // namespace quadrille::sizing
