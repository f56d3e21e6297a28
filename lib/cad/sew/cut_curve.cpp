#include "sew/cut_curve.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/tolerance.hpp"
#include "curve/nurbs.hpp"
#include "curve/pole_box.hpp"
#include "outline/outline_checks.hpp"

namespace quadrille::sew {

Nurbs joined_curve(const Nurbs& a, const Nurbs& b) {
  if (a.degree != b.degree) throw Defect("joined_curve: curves of different degrees");
  Nurbs joined = a;
  joined.knots.pop_back();
  for (auto knot = b.knots.begin() + b.degree + 1; knot != b.knots.end(); ++knot)
    joined.knots.push_back(a.end() + (*knot - b.begin()));
  // All weights of a rational curve may be multiplied by one number.
  const double factor = a.weights.back() / b.weights.front();
  joined.poles.insert(joined.poles.end(), b.poles.begin() + 1, b.poles.end());
  for (auto weight = b.weights.begin() + 1; weight != b.weights.end(); ++weight)
    joined.weights.push_back(factor * *weight);
  return joined;
}

namespace {

double at_inner_knot(const Nurbs& curve, double t, double near) {
  for (const double knot : curve.knots)
    if (std::abs(knot - t) <= near && knot > curve.begin() && knot < curve.end()) return knot;
  return t;
}

std::vector<CutPiece> open_pieces(const Nurbs& curve, const std::vector<Cut>& cuts, int start) {
  std::vector<CutPiece> pieces;
  double begin = curve.begin();
  for (const Cut& cut : cuts) {
    pieces.push_back({curve::trimmed(curve, begin, cut.t), start});
    begin = cut.t, start = cut.place;
  }
  pieces.push_back({curve::trimmed(curve, begin, curve.end()), start});
  return pieces;
}

}  // namespace

std::vector<CutPiece> cut_curve(const Nurbs& curve, std::vector<Cut> cuts, int start) {
  // A cut as near to a knot or the seam is at it, so that no piece has a span as short.
  const double near = tolerance::round_off * (curve.end() - curve.begin());
  for (Cut& cut : cuts) cut.t = at_inner_knot(curve, cut.t, near);
  std::stable_sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.t < b.t; });
  if (start >= 0 || cuts.empty()) return open_pieces(curve, cuts, start);
  if (curve.end() - cuts.back().t <= near) std::rotate(cuts.begin(), cuts.end() - 1, cuts.end());
  if (const Cut first = cuts.front(); std::min(first.t - curve.begin(), curve.end() - first.t) <= near) {
    cuts.erase(cuts.begin());
    return open_pieces(curve, cuts, first.place);
  }
  const Nurbs head = curve::trimmed(curve, curve.begin(), cuts.front().t);
  const Nurbs tail = curve::trimmed(curve, cuts.back().t, curve.end());
  std::vector<CutPiece> pieces;
  for (size_t i = 0; i + 1 < cuts.size(); ++i)
    pieces.push_back({curve::trimmed(curve, cuts[i].t, cuts[i + 1].t), cuts[i].place});
  pieces.push_back({joined_curve(tail, head), cuts.back().place});
  return pieces;
}

namespace {

/// Parts of two curves that are compared, at most; two curves that cross need some tens.
constexpr int most_comparisons = 20000;

/// Of the angle at which curves cross; at a smaller one they touch.
constexpr double least_sine = 1e-3;

using outline::ChordPiece;

class Search {
 public:
  Search(const Nurbs& a, const Nurbs& b, double tol, const std::string& what) : a_(a), b_(b), tol_(tol), what_(what) {}

  std::vector<CurveCrossing> all() {
    const std::vector<ChordPiece> of_b = outline::chord_pieces(b_);
    for (const ChordPiece& p : outline::chord_pieces(a_))
      for (const ChordPiece& q : of_b) compare(p, q);
    std::sort(found_.begin(), found_.end(),
              [](const CurveCrossing& x, const CurveCrossing& y) { return x.t_a < y.t_a; });
    return found_;
  }

 private:
  void compare(const ChordPiece& p, const ChordPiece& q) {
    if (distance_of_segments(p.a(), p.b(), q.a(), q.b()) > p.width + q.width) return;
    if (++comparisons_ > most_comparisons) refuse(p.a());
    if (std::max(p.width, q.width) <= tol_ / 4) return add(p, q);
    const bool first = p.width >= q.width;
    const auto [begin, end] = (first ? p : q).halves();
    for (const ChordPiece* half : {&begin, &end}) first ? compare(*half, q) : compare(p, *half);
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
  void add(const ChordPiece& p, const ChordPiece& q) {
    const Vec2 d = p.b() - p.a(), e = q.b() - q.a();
    const double n = cross(d, e);
    if (n == 0) return;
    CurveCrossing x{p.at(cross(q.a() - p.a(), e) / n), q.at(cross(q.a() - p.a(), d) / n), {}};
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
  if (!curve::pole_box(a).meets(curve::pole_box(b))) return {};
  return Search(a, b, tol, what).all();
}

}  // namespace quadrille::sew
