#include "curve/fit_line.hpp"

#include <optional>
#include <vector>

#include "curve/nurbs.hpp"

namespace quadrille::curve {
namespace {

class Fit {
 public:
  Fit(const CurveFunction& curve, double length, double tol) : curve_(curve), length_(length), tol_(tol) {
    for (int i = 0; i <= 8; ++i) s_.push_back(i == 8 ? length : length * i / 8);
    Vec2 unused;
    curve(0, start_);
    curve(length, end_);
    for (const double s : s_) x_.push_back(curve(s, unused));
    tests_.resize(8);
  }

  Nurbs run() {
    Nurbs spline = cubic_spline(s_, x_, start_, end_);
    for (int round = 0; round < 24 && refine(spline); ++round) spline = cubic_spline(s_, x_, start_, end_);
    return spline;
  }

 private:
  /// Positions in an interval, computed once: most curves cost more than their splines.
  struct Tests {
    std::optional<Vec2> middle, first_quarter, last_quarter;
  };

  Vec2 position(double s, std::optional<Vec2>& known) {
    Vec2 unused;
    if (!known) known = curve_(s, unused);
    return *known;
  }

  bool is_close(const Nurbs& spline, double s, std::optional<Vec2>& known) {
    return norm2(point(spline, s) - position(s, known)) <= tol_ * tol_;
  }

  bool refine(const Nurbs& spline) {
    std::vector<double> s{s_.front()};
    std::vector<Vec2> x{x_.front()};
    std::vector<Tests> tests;
    for (size_t i = 0; i + 1 < s_.size(); ++i) {
      const double a = s_[i], b = s_[i + 1], middle = (a + b) / 2;
      Tests& here = tests_[i];
      const bool close = is_close(spline, middle, here.middle) &&
                         is_close(spline, (a + middle) / 2, here.first_quarter) &&
                         is_close(spline, (middle + b) / 2, here.last_quarter);
      if (!close && b - a > 1e-6 * length_) {
        s.push_back(middle), x.push_back(position(middle, here.middle));
        tests.push_back({here.first_quarter, {}, {}}), tests.push_back({here.last_quarter, {}, {}});
      } else {
        tests.push_back(here);
      }
      s.push_back(b), x.push_back(x_[i + 1]);
    }
    const bool refined = s.size() > s_.size();
    s_ = std::move(s), x_ = std::move(x), tests_ = std::move(tests);
    return refined;
  }

  const CurveFunction& curve_;
  double length_, tol_;
  Vec2 start_, end_;
  std::vector<double> s_;
  std::vector<Vec2> x_;
  std::vector<Tests> tests_;  // of the intervals of s_
};

}  // namespace

Nurbs fit_line(const CurveFunction& curve, double length, double tol) { return Fit(curve, length, tol).run(); }

}  // namespace quadrille::curve
