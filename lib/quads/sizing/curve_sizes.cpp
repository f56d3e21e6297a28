#include "sizing/curve_sizes.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "base/angle.hpp"
#include "base/tolerance.hpp"
#include "curve/nurbs.hpp"
#include "curve/pole_box.hpp"

namespace quadrille::sizing {
namespace {

constexpr double resolution = 1e-5;

/// Sizes at bends: measured to lower the errors of smooth solutions, potentials and layers, and not to raise that of
/// waves, which unequal elements have.
struct Bends {
  double elements_per_turn = 24;
  double least = 0.75;  ///< of the greatest size
};
constexpr Bends bends;
constexpr int least_depth = 2, max_depth = 13;

/// Size at a parameter, from the left or the right of it.
using SizeAt = std::function<double(double t, bool from_left)>;

struct Sample {
  double t;
  Vec2 position;
  double size;
};

/// Halves a smooth part of a curve until segments are near enough.
class Segmenter {
 public:
  Segmenter(const Nurbs& curve, SizeAt size, double slope) : curve_(curve), size_(std::move(size)), slope_(slope) {}

  void add_span(double low, double high) { divide(sample(low, false), sample(high, true), 0); }
  std::vector<SizeSegment> segments() { return std::move(segments_); }

 private:
  Sample sample(double t, bool from_left) const { return {t, curve::point(curve_, t), size_(t, from_left)}; }

  void divide(const Sample& a, const Sample& b, int depth) {
    const Sample middle = sample((a.t + b.t) / 2, false);
    const double off = std::abs(middle.size - (a.size + b.size) / 2);
    // The size at the curve, from a segment that lies the sagitta away from it, is greater by slope times that.
    const double sagitta = distance_to_line(middle.position, a.position, b.position);
    const double error = std::max(off, slope_ * sagitta);
    if (depth >= max_depth || (depth >= least_depth && error <= resolution * std::min(a.size, b.size))) {
      segments_.push_back({a.position, middle.position, a.size, middle.size});
      segments_.push_back({middle.position, b.position, middle.size, b.size});
      return;
    }
    divide(a, middle, depth + 1);
    divide(middle, b, depth + 1);
  }

  static double distance_to_line(Vec2 x, Vec2 a, Vec2 b) {
    const double length = distance(a, b);
    return length > 0 ? std::abs(cross(b - a, x - a)) / length : distance(x, a);
  }

  const Nurbs& curve_;
  SizeAt size_;
  double slope_;
  std::vector<SizeSegment> segments_;
};

std::vector<SizeSegment> segments_of(const Nurbs& curve, const SizeAt& size, double slope) {
  Segmenter segmenter(curve, size, slope);
  for (std::size_t i = 1; i < curve.knots.size(); ++i)
    if (curve.knots[i - 1] < curve.knots[i]) segmenter.add_span(curve.knots[i - 1], curve.knots[i]);
  return segmenter.segments();
}

bool is_straight(const Nurbs& curve) { return curve.degree == 1; }

/// The halves of the spans, each less than a right angle. `size`: all along.
std::vector<SizeSegment> arcs_of(const Nurbs& curve, const curve::Carrier& circle, double size) {
  std::vector<SizeSegment> arcs;
  for (std::size_t i = 1; i < curve.knots.size(); ++i) {
    const double low = curve.knots[i - 1], high = curve.knots[i], middle = (low + high) / 2;
    if (!(low < high)) continue;
    for (const auto& [from, to] : {std::pair(low, middle), std::pair(middle, high)}) {
      Vec2 a = curve::point(curve, from), b = curve::point(curve, to);
      if (cross(a - circle.point, b - circle.point) < 0) std::swap(a, b);
      arcs.push_back({a, b, size, size, -1, circle.radius, circle.point});
    }
  }
  return arcs;
}

/// The size by the curvature, |1 / radius|, between `least` and `greatest`; segments all at `greatest` are omitted.
template <class Size>
std::vector<SizeSegment> segments_by_bend(const Nurbs& curve, const Size& size_at, double least, double greatest,
                                          double slope) {
  if (is_straight(curve)) return {};
  const auto size = [&](double t, bool from_left) {
    const double bend = std::abs(curve::curvature(curve, t, from_left));
    return bend > 0 ? std::clamp(size_at(bend), least, greatest) : greatest;
  };
  std::vector<SizeSegment> segments = segments_of(curve, size, slope);
  std::erase_if(segments, [&](const SizeSegment& s) { return std::min(s.size_a, s.size_b) >= greatest; });
  return segments;
}

}  // namespace

std::vector<SizeSegment> segments_near(const Nurbs& curve, double size, double slope) {
  if (const curve::Carrier carrier = curve::carrier_of(curve); carrier.kind == curve::CurveKind::arc)
    return arcs_of(curve, carrier, size);
  if (!is_straight(curve))
    return segments_of(
        curve, [size](double, bool) { return size; }, slope);
  std::vector<SizeSegment> segments;
  for (std::size_t i = 1; i < curve.poles.size(); ++i)
    segments.push_back({curve.poles[i - 1], curve.poles[i], size, size});
  return segments;
}

GrowingSize growing_size(const CadFace& face, const std::vector<int>& curves, double size, double other_size) {
  GrowingSize growing{face.joints[curves[0]].position, face.joints[curves[0]].position, size, other_size};
  const auto is_before = [&](Vec2 a, Vec2 b) {
    const double tol = tolerance::same_point * face.diameter;
    return std::abs(a.x - b.x) > tol ? a.x < b.x : a.y < b.y - tol;
  };
  for (const int c : curves)
    for (const int joint : {c, face.next_in_loop(c)}) {
      const Vec2 x = face.joints[joint].position;
      if (is_before(x, growing.end)) growing.end = x;
      if (is_before(growing.other_end, x)) growing.other_end = x;
    }
  return growing;
}

std::vector<SizeSegment> segments_near(const Nurbs& curve, const GrowingSize& size, double slope) {
  const double whole = distance(size.end, size.other_end);
  const auto at = [&](double t, bool) {
    const double part = whole > 0 ? std::min(1.0, distance(curve::point(curve, t), size.end) / whole) : 0;
    return size.size + part * (size.other_size - size.size);
  };
  return segments_of(curve, at, slope);
}

std::vector<SizeSegment> segments_by_curvature(const Nurbs& curve, double elements_per_turn, double least,
                                               double greatest, double slope) {
  return segments_by_bend(
      curve, [&](double bend) { return 2 * pi / (elements_per_turn * bend); }, least, greatest, slope);
}

std::vector<SizeSegment> segments_by_sag(const Nurbs& curve, double sag, double greatest, double slope) {
  return segments_by_bend(
      curve, [&](double bend) { return std::sqrt(8 * sag / bend); }, sag, greatest, slope);
}

SizeField sizes_at_bends(const CadFace& face, const SizeField& sizes) {
  const double greatest = sizes.greatest();
  const double slope = sizes.is_uniform() ? std::log(SizeField::default_growth) : sizes.slope();
  std::vector<SizeSegment> segments;
  for (const Nurbs& curve : face.curves) {
    const std::vector<SizeSegment> own =
        segments_by_curvature(curve, bends.elements_per_turn, bends.least * greatest, greatest, slope);
    segments.insert(segments.end(), own.begin(), own.end());
  }
  return sizes.with(segments);
}

}  // namespace quadrille::sizing
