#include "curve/fit_line.hpp"

#include <map>
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
  }

  Nurbs run() {
    Nurbs spline = cubic_spline(s_, x_, start_, end_);
    for (int round = 0; round < 24 && refine(spline); ++round) spline = cubic_spline(s_, x_, start_, end_);
    return spline;
  }

 private:
  Vec2 position(double s) {
    const auto known = cache_.find(s);
    if (known != cache_.end()) return known->second;
    Vec2 unused;
    return cache_[s] = curve_(s, unused);
  }

  bool is_close(const Nurbs& spline, double s) { return distance(point(spline, s), position(s)) <= tol_; }

  bool refine(const Nurbs& spline) {
    std::vector<double> s{s_.front()};
    std::vector<Vec2> x{x_.front()};
    for (size_t i = 0; i + 1 < s_.size(); ++i) {
      const double a = s_[i], b = s_[i + 1], middle = (a + b) / 2;
      const bool close =
          is_close(spline, middle) && is_close(spline, (a + middle) / 2) && is_close(spline, (middle + b) / 2);
      if (!close && b - a > 1e-6 * length_) s.push_back(middle), x.push_back(position(middle));
      s.push_back(b), x.push_back(x_[i + 1]);
    }
    const bool refined = s.size() > s_.size();
    s_ = std::move(s), x_ = std::move(x);
    return refined;
  }

  const CurveFunction& curve_;
  double length_, tol_;
  Vec2 start_, end_;
  std::vector<double> s_;
  std::vector<Vec2> x_;
  std::map<double, Vec2> cache_;
};

}  // namespace

Nurbs fit_line(const CurveFunction& curve, double length, double tol) { return Fit(curve, length, tol).run(); }

}  // namespace quadrille::curve
