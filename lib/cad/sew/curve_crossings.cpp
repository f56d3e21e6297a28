#include "sew/curve_crossings.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/position_text.hpp"
#include "base/segments.hpp"
#include "curve/nurbs.hpp"
#include "curve/pole_box.hpp"

namespace quadrille::sew {
namespace {

/// Parts of two curves that are compared, at most; two curves that cross need some tens.
constexpr int most_comparisons = 20000;

/// Of the angle at which curves cross; at a smaller one they touch.
constexpr double least_sine = 1e-3;

/// A part of a curve between knots, within `width` of its chord.
struct Part {
  Nurbs curve;
  double width = 0;

  Vec2 a() const { return curve.poles.front(); }
  Vec2 b() const { return curve.poles.back(); }
};

Part part_of(Nurbs curve) {
  Part part{std::move(curve), 0};
  for (const Vec2 p : part.curve.poles) part.width = std::max(part.width, distance_to_segment(p, part.a(), part.b()));
  return part;
}

std::vector<Part> parts_of(const Nurbs& curve) {
  std::vector<Part> parts;
  for (size_t k = 1; k < curve.knots.size(); ++k)
    if (curve.knots[k - 1] < curve.knots[k])
      parts.push_back(part_of(curve::trimmed(curve, curve.knots[k - 1], curve.knots[k])));
  return parts;
}

class Search {
 public:
  Search(const Nurbs& a, const Nurbs& b, double tol, const std::string& what) : a_(a), b_(b), tol_(tol), what_(what) {}

  std::vector<CurveCrossing> all() {
    const std::vector<Part> of_b = parts_of(b_);
    for (const Part& p : parts_of(a_))
      for (const Part& q : of_b) compare(p, q);
    std::sort(found_.begin(), found_.end(),
              [](const CurveCrossing& x, const CurveCrossing& y) { return x.t_a < y.t_a; });
    return found_;
  }

 private:
  void compare(const Part& p, const Part& q) {
    if (distance_of_segments(p.a(), p.b(), q.a(), q.b()) > p.width + q.width) return;
    if (++comparisons_ > most_comparisons) refuse(p.a());
    if (std::max(p.width, q.width) <= tol_ / 4) return add(p, q);
    const bool first = p.width >= q.width;
    const Nurbs& halved = first ? p.curve : q.curve;
    const double middle = (halved.begin() + halved.end()) / 2;
    for (const Part& half : {part_of(curve::trimmed(halved, halved.begin(), middle)),
                             part_of(curve::trimmed(halved, middle, halved.end()))})
      first ? compare(half, q) : compare(p, half);
  }

  [[noreturn]] void refuse(Vec2 x) const {
    throw FormatError(what_ + " touch or run along each other at " + rounded_position_text(x) +
                      ": let them cross at an angle, or remove one of them");
  }

  /// Whether one curve begins or ends at x where the other one does: curves that follow each other smoothly.
  bool is_common_end(Vec2 x) const {
    for (const Vec2 end_of_a : {a_.poles.front(), a_.poles.back()})
      for (const Vec2 end_of_b : {b_.poles.front(), b_.poles.back()})
        if (distance(end_of_a, end_of_b) <= tol_ && distance(end_of_a, x) <= 2 * tol_) return true;
    return false;
  }

  // Newton's method from the crossing of the chords.
  void add(const Part& p, const Part& q) {
    const Vec2 d = p.b() - p.a(), e = q.b() - q.a();
    const double n = cross(d, e);
    if (n == 0) return;
    const auto at = [](const Part& part, double fraction) {
      return part.curve.begin() + std::clamp(fraction, 0.0, 1.0) * (part.curve.end() - part.curve.begin());
    };
    CurveCrossing x{at(p, cross(q.a() - p.a(), e) / n), at(q, cross(q.a() - p.a(), d) / n), {}};
    for (int step = 0; step < 20; ++step) {
      const auto u = curve::point_and_derivative(a_, x.t_a), v = curve::point_and_derivative(b_, x.t_b);
      const double determinant = cross(u.derivative, v.derivative);
      const Vec2 gap = v.point - u.point;
      if (determinant == 0 || norm2(gap) == 0) break;
      x.t_a = std::clamp(x.t_a + cross(gap, v.derivative) / determinant, a_.begin(), a_.end());
      x.t_b = std::clamp(x.t_b + cross(gap, u.derivative) / determinant, b_.begin(), b_.end());
    }
    x.position = curve::point(a_, x.t_a);
    if (!(distance(x.position, curve::point(b_, x.t_b)) <= tol_)) return;
    const Vec2 u = curve::tangent(a_, x.t_a), v = curve::tangent(b_, x.t_b);
    if (std::abs(cross(u, v)) < least_sine && is_common_end(x.position)) return;
    if (std::abs(cross(u, v)) < least_sine) refuse(x.position);
    for (const CurveCrossing& known : found_)
      if (distance(known.position, x.position) <= tol_) return;
    found_.push_back(x);
  }

  const Nurbs &a_, &b_;
  double tol_;
  const std::string& what_;
  int comparisons_ = 0;
  std::vector<CurveCrossing> found_;
};

}  // namespace

std::vector<CurveCrossing> curve_crossings(const Nurbs& a, const Nurbs& b, double tol, const std::string& what) {
  const curve::PoleBox p = curve::pole_box(a), q = curve::pole_box(b);
  if (p.low.x > q.high.x || q.low.x > p.high.x || p.low.y > q.high.y || q.low.y > p.high.y) return {};
  return Search(a, b, tol, what).all();
}

}  // namespace quadrille::sew
