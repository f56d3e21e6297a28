#include "sizing/curve_sizes.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "base/angle.hpp"
#include "base/tolerance.hpp"
#include "curve/nurbs.hpp"
#include "curve/pole_box.hpp"
#include "surface/nurbs_surface.hpp"

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
  Vec3 position;
  double size;
};

/// Halves a smooth part of a curve until segments are near enough.
class Segmenter {
 public:
  Segmenter(const SourceCurve& curve, SizeAt size, double slope)
      : curve_(curve), size_(std::move(size)), slope_(slope) {}

  void add_span(double low, double high) { divide(sample(low, false), sample(high, true), 0); }
  std::vector<SizeSegment> segments() { return std::move(segments_); }

 private:
  Sample sample(double t, bool from_left) const { return {t, curve_.at(t), size_(t, from_left)}; }

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

  static double distance_to_line(Vec3 x, Vec3 a, Vec3 b) {
    const double length = distance(a, b);
    return length > 0 ? norm(cross(b - a, x - a)) / length : distance(x, a);
  }

  const SourceCurve& curve_;
  SizeAt size_;
  double slope_;
  std::vector<SizeSegment> segments_;
};

std::vector<SizeSegment> segments_of(const SourceCurve& curve, const SizeAt& size, double slope) {
  Segmenter segmenter(curve, size, slope);
  const std::vector<double>& knots = curve.knots();
  for (std::size_t i = 1; i < knots.size(); ++i)
    if (knots[i - 1] < knots[i]) segmenter.add_span(knots[i - 1], knots[i]);
  return segmenter.segments();
}

/// The halves of the spans, each less than a right angle. `size`: all along.
std::vector<SizeSegment> arcs_of(const Nurbs& curve, const curve::Carrier& circle, double size) {
  std::vector<SizeSegment> arcs;
  for (std::size_t i = 1; i < curve.knots.size(); ++i) {
    const double low = curve.knots[i - 1], high = curve.knots[i], middle = (low + high) / 2;
    if (!(low < high)) continue;
    for (const auto& [from, to] : {std::pair(low, middle), std::pair(middle, high)}) {
      Vec2 a = curve::point(curve, from), b = curve::point(curve, to);
      if (cross(a - circle.point, b - circle.point) < 0) std::swap(a, b);
      arcs.push_back({in_space(a), in_space(b), size, size, -1, circle.radius, circle.point});
    }
  }
  return arcs;
}

/// The size by the curvature, |1 / radius|, between `least` and `greatest`; segments all at `greatest` are omitted.
template <class Size>
std::vector<SizeSegment> segments_by_bend(const SourceCurve& curve, const Size& size_at, double least, double greatest,
                                          double slope) {
  if (curve.is_straight()) return {};
  const auto size = [&](double t, bool from_left) {
    const double bend = curve.curvature(t, from_left);
    return bend > 0 ? std::clamp(size_at(bend), least, greatest) : greatest;
  };
  std::vector<SizeSegment> segments = segments_of(curve, size, slope);
  std::erase_if(segments, [&](const SizeSegment& s) { return std::min(s.size_a, s.size_b) >= greatest; });
  return segments;
}

}  // namespace

Vec3 SourceCurve::at(double t) const {
  return plane_ ? in_space(curve::point(*plane_, t)) : surface::point(*space_, t);
}

double SourceCurve::curvature(double t, bool from_left) const {
  if (plane_) return std::abs(curve::curvature(*plane_, t, from_left));
  const auto d = surface::derivatives(*space_, t, from_left);
  return norm(cross(d[1], d[2])) / std::pow(norm(d[1]), 3);
}

std::vector<SizeSegment> segments_near(const SourceCurve& curve, double size, double slope) {
  if (const Nurbs* in_plane = curve.in_plane())
    if (const curve::Carrier carrier = curve::carrier_of(*in_plane); carrier.kind == curve::CurveKind::arc)
      return arcs_of(*in_plane, carrier, size);
  if (!curve.is_straight())
    return segments_of(
        curve, [size](double, bool) { return size; }, slope);
  std::vector<SizeSegment> segments;
  for (std::size_t i = 1; i < curve.num_poles(); ++i)
    segments.push_back({curve.pole(i - 1), curve.pole(i), size, size});
  return segments;
}

GrowingSize growing_size(const CadFace& face, const std::vector<int>& curves, double size, double other_size) {
  const auto joint = [&](int c) {
    return face.chart ? face.chart->space_curves[c].poles.front() : in_space(face.joints[c].position);
  };
  GrowingSize growing{joint(curves[0]), joint(curves[0]), size, other_size};
  const auto is_before = [&](Vec3 a, Vec3 b) {
    const double tol = tolerance::same_point * face.diameter;
    if (std::abs(a.x - b.x) > tol) return a.x < b.x;
    return std::abs(a.y - b.y) > tol ? a.y < b.y : a.z < b.z - tol;
  };
  for (const int c : curves)
    for (const int end : {c, face.next_in_loop(c)}) {
      const Vec3 x = joint(end);
      if (is_before(x, growing.end)) growing.end = x;
      if (is_before(growing.other_end, x)) growing.other_end = x;
    }
  return growing;
}

std::vector<SizeSegment> segments_near(const SourceCurve& curve, const GrowingSize& size, double slope) {
  const double whole = distance(size.end, size.other_end);
  const auto at = [&](double t, bool) {
    const double part = whole > 0 ? std::min(1.0, distance(curve.at(t), size.end) / whole) : 0;
    return size.size + part * (size.other_size - size.size);
  };
  return segments_of(curve, at, slope);
}

std::vector<SizeSegment> segments_by_curvature(const SourceCurve& curve, double elements_per_turn, double least,
                                               double greatest, double slope) {
  return segments_by_bend(
      curve, [&](double bend) { return 2 * pi / (elements_per_turn * bend); }, least, greatest, slope);
}

std::vector<SizeSegment> segments_by_sag(const SourceCurve& curve, double sag, double greatest, double slope) {
  return segments_by_bend(
      curve, [&](double bend) { return std::sqrt(8 * sag / bend); }, sag, greatest, slope);
}

SizeField sizes_at_bends(const CadFace& face, const SizeField& sizes) {
  const double greatest = sizes.greatest_in_space();
  const double slope = sizes.is_uniform() ? std::log(SizeField::default_growth) : sizes.slope();
  std::vector<SizeSegment> segments;
  for (int c = 0; c < face.num_curves(); ++c) {
    const std::vector<SizeSegment> own =
        segments_by_curvature({face, c}, bends.elements_per_turn, bends.least * greatest, greatest, slope);
    segments.insert(segments.end(), own.begin(), own.end());
  }
  return sizes.with(segments);
}

}  // namespace quadrille::sizing
