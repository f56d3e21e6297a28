#include "cad/periodic_in_space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "cad/periodic_pairing.hpp"
#include "curve/chain.hpp"
#include "curve/least_squares_spline.hpp"
#include "curve/nurbs.hpp"
#include "model/periodic.hpp"
#include "space/space_curve.hpp"
#include "surface/nurbs_surface.hpp"
#include "surface/periodic_motion.hpp"
#include "surface/space_extent.hpp"

namespace quadrille::cad {
namespace {

constexpr int samples_in_span = 8;
constexpr double chart_fit = 1e-8;      ///< diameters: of a curve in the chart with other parameters from the old one
constexpr double chart_lengths = 1e-5;  ///< diameters: greatest difference of lengths along both sides in the chart
constexpr int least_degree = 5;         ///< of its spline
constexpr int most_halvings = 6;        ///< of its knot spans

/// Each knot once.
std::vector<double> breaks_of(const std::vector<double>& knots) {
  std::vector<double> breaks(knots);
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
  return breaks;
}

/// `count` parameters in each span, the first at its start, and the last end.
std::vector<double> samples_between(const std::vector<double>& breaks, int count) {
  std::vector<double> samples;
  for (std::size_t k = 1; k < breaks.size(); ++k)
    for (int i = 0; i < count; ++i) samples.push_back(breaks[k - 1] + (breaks[k] - breaks[k - 1]) * i / count);
  samples.push_back(breaks.back());
  return samples;
}

/// From the parameters of a curve linearly to those of another one.
class LinearMap {
 public:
  LinearMap(const SpaceCurve& from, const SpaceCurve& to) : from_(from.begin()), to_(to.begin()), end_(to.end()) {
    ratio_ = (to.end() - to.begin()) / (from.end() - from.begin());
  }
  double operator()(double t) const { return std::min(to_ + (t - from_) * ratio_, end_); }

 private:
  double from_, to_, end_, ratio_;
};

/// A curve of the chart whose curve in space becomes `after`, the same set of points as `before`.
class ChartCurve {
 public:
  ChartCurve(const Nurbs& in_chart, const SpaceCurve& before, const SpaceCurve& after, double same)
      : in_chart_(in_chart), before_(before), after_(after), same_(same) {}

  /// With the parameters of `after`; std::nullopt if no spline with up to 64 times the knots is within `tolerance`.
  std::optional<Nurbs> with_new_parameters(double tolerance) const {
    if (are_parameters_linear()) return with_linear_parameters();
    std::vector<double> breaks = all_breaks();
    for (int round = 0; round <= most_halvings; ++round) {
      std::optional<Nurbs> spline = fitted(breaks);
      if (spline && error_of(*spline, breaks) <= tolerance) return spline;
      breaks = samples_between(breaks, 2);
    }
    return std::nullopt;
  }

 private:
  bool are_parameters_linear() const {
    const LinearMap map(after_, before_);
    const auto is_same = [&](double t) {
      return distance(surface::point(before_, map(t)), surface::point(after_, t)) <= same_;
    };
    return std::ranges::all_of(samples_between(breaks_of(after_.knots), samples_in_span), is_same);
  }

  Nurbs with_linear_parameters() const {
    const LinearMap map(before_, after_);
    Nurbs result = in_chart_;
    for (double& knot : result.knots)
      knot = knot == before_.begin() ? after_.begin() : knot == before_.end() ? after_.end() : map(knot);
    return result;
  }

  double parameter_before(double t) const {
    if (t == after_.begin()) return before_.begin();
    if (t == after_.end()) return before_.end();
    return surface::project(before_, surface::point(after_, t)).t;
  }

  /// Where `after` or the curve of the chart has a knot.
  std::vector<double> all_breaks() const {
    std::vector<double> breaks = breaks_of(after_.knots);
    const double least = 1e-6 * (after_.end() - after_.begin());
    for (const double knot : breaks_of(in_chart_.knots)) {
      const double t = surface::project(after_, surface::point(before_, knot)).t;
      if (std::ranges::none_of(breaks, [&](double b) { return std::abs(b - t) < least; })) breaks.push_back(t);
    }
    std::ranges::sort(breaks);
    return breaks;
  }

  std::optional<Nurbs> fitted(const std::vector<double>& breaks) const {
    const int degree = std::max(least_degree, in_chart_.degree);
    std::vector<curve::FitKnot> knots;
    for (const double t : breaks) knots.push_back({t, degree - 1});
    std::vector<curve::FitPoint> points;
    for (const double t : samples_between(breaks, 3 * degree))
      points.push_back({t, curve::point(in_chart_, parameter_before(t))});
    return curve::least_squares_spline(
        degree, knots, points,
        {in_chart_.poles.front(), end_derivative(false), in_chart_.poles.back(), end_derivative(true)});
  }

  /// By the parameter of `after`.
  Vec2 end_derivative(bool at_end) const {
    const auto speed = [&](const SpaceCurve& c) {
      return norm(surface::derivatives(c, at_end ? c.end() : c.begin(), at_end)[1]);
    };
    const double t = at_end ? in_chart_.end() : in_chart_.begin();
    return speed(after_) / speed(before_) * curve::derivatives(in_chart_, t, at_end)[1];
  }

  double error_of(const Nurbs& spline, const std::vector<double>& breaks) const {
    double worst = 0;
    for (const double t : samples_between(breaks, 2 * samples_in_span + 1))
      worst = std::max(worst, distance(curve::point(spline, t), curve::point(in_chart_, parameter_before(t))));
    return worst;
  }

  const Nurbs& in_chart_;
  const SpaceCurve &before_, &after_;
  double same_;
};

/// Sides of a face with a chart (PeriodicPairing).
class SidesInSpace {
 public:
  using Point = Vec3;
  struct Motion : SpaceMotion {
    Vec3 image(Vec3 x) const { return surface::image(*this, x); }
    Vec3 original(Vec3 x) const { return surface::original(*this, x); }
  };
  struct Foot {
    int curve = 0;  ///< index of `curves`
    double t = 0, distance = HUGE_VAL;
  };
  struct Feet {
    const Chart& chart;
    std::vector<int> curves;

    Foot nearest(Vec3 x) const {
      Foot best;
      for (int k = 0; k < std::ssize(curves); ++k)
        if (const auto foot = surface::project(chart.space_curves[curves[k]], x); foot.distance < best.distance)
          best = {k, foot.t, foot.distance};
      return best;
    }
  };

  SidesInSpace(CadFace& face, const PeriodicRequest& request)
      : face_(face), request_(request), chart_(*face.chart), diameter_(surface::diameter(chart_)) {}

  double diameter() const { return diameter_; }
  Vec3 start(int curve) const { return chart_.space_curves[curve].poles.front(); }
  Vec3 end(int curve) const { return chart_.space_curves[curve].poles.back(); }
  std::string place(Vec3 x) const { return position_text(x); }

  Motion given() const {
    throw UsageError(fmt::format("{}: the motion of sides of a curved face is found from them: leave it out, {}={}",
                                 request_.where, request_.first, request_.second));
  }
  Motion motion_between(const SidePart& a, const SidePart& b) const {
    return {surface::motion_between(chart_, a.curves, b.curves)};
  }
  std::string text(const Motion& motion) const {
    const auto [direction, angle] = surface::rotation_axis(motion);
    const Vec3 shift = motion.shift;
    if (angle == 0) return fmt::format("a translation by ({:.9g}, {:.9g}, {:.9g})", shift.x, shift.y, shift.z);
    return fmt::format("a rotation by {:.9g} degrees about the direction ({:.6g}, {:.6g}, {:.6g})", degrees(angle),
                       direction.x, direction.y, direction.z);
  }

  Feet feet_on(const std::vector<int>& curves) const { return {chart_, curves}; }
  std::vector<Vec3> samples(const std::vector<int>& curves) const {
    std::vector<Vec3> points;
    for (const int c : curves)
      for (const double t : samples_between(breaks_of(chart_.space_curves[c].knots), samples_in_span))
        points.push_back(surface::point(chart_.space_curves[c], t));
    return points;
  }

  void split(int curve, double t) {
    const SpaceCurve whole = chart_.space_curves[curve];
    SpaceCurve rest = space::trimmed(whole, t, whole.end());
    for (double& knot : rest.knots) knot -= t;
    chart_.space_curves[curve] = space::trimmed(whole, whole.begin(), t);
    rest.poles.front() = chart_.space_curves[curve].poles.back();
    chart_.space_curves.insert(chart_.space_curves.begin() + curve + 1, std::move(rest));
    split_curve(face_, curve, t);
  }

  PeriodicPair pair_of(int from, int to, const Motion& motion) const {
    return {{from, to}, surface::rotation_axis(motion).angle, {}};
  }

  void replace_by_image(int from, int to, const Motion& motion) {
    SpaceCurve image = surface::reversed(chart_.space_curves[from]);
    for (Vec3& pole : image.poles) pole = motion.image(pole);
    const SpaceCurve before = chart_.space_curves[to];
    const ChartCurve curve(face_.curves[to], before, image, relative_fit * diameter_);
    std::optional<Nurbs> in_chart = curve.with_new_parameters(chart_fit * face_.diameter);
    if (!in_chart)
      throw ComputeError(
          fmt::format("{}: '{}' at {} has too uneven parameters to get those of '{}': draw it as a copy of that side",
                      request_.where, face_.curve_names[to], place(start(to)), face_.curve_names[from]));
    face_.curves[to] = *std::move(in_chart);
    require_equal_lengths(from, to);
    chart_.space_curves[to] = image;
    move_joint(before.poles.front(), image.poles.front());
    move_joint(before.poles.back(), image.poles.back());
  }

  /// Gives the face its changed curves in space.
  void finish() { face_.chart = std::make_shared<const Chart>(std::move(chart_)); }

 private:
  /// In the chart, up to points of equal parameters: nodes are placed by them.
  void require_equal_lengths(int from, int to) const {
    const curve::ArcLength first(face_.curves[from]), second(face_.curves[to]);
    for (const double t : samples_between(breaks_of(face_.curves[from].knots), samples_in_span)) {
      const double other = second.total() - second.at(periodic_parameter(face_, from, t, to));
      if (std::abs(first.at(t) - other) <= chart_lengths * face_.diameter) continue;
      throw UsageError(fmt::format(
          "{}: the chart of the face scales '{}' and '{}' differently, by {:.2g} diameters up to {}: on a curved face "
          "both sides must be on its outline, not on a hole",
          request_.where, face_.curve_names[from], face_.curve_names[to],
          std::abs(first.at(t) - other) / face_.diameter, place(surface::point(chart_.space_curves[from], t))));
    }
  }

  // Whatever meets a joint meets it in its new place.
  void move_joint(Vec3 from, Vec3 to) {
    const double same = relative_same * diameter_;
    for (SpaceCurve& curve : chart_.space_curves)
      for (Vec3* const end : {&curve.poles.front(), &curve.poles.back()})
        if (distance(*end, from) <= same) *end = to;
  }

  CadFace& face_;
  const PeriodicRequest& request_;
  Chart chart_;
  double diameter_;
};

}  // namespace

void pair_sides_in_space(CadFace& face, const PeriodicRequest& request) {
  SidesInSpace sides(face, request);
  PeriodicPairing(face, request, sides).pair();
  sides.finish();
}

}  // namespace quadrille::cad
