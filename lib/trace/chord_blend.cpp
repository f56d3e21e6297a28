#include "trace/chord_blend.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"

namespace quadrille {
namespace {

constexpr int num_samples = 64;

}  // namespace

double blend_length(const Chain& from, const Chain& to) { return (from.length() + to.length()) / 2; }

CurveFunction blended_curve(const Chain& from, const Chain& to) {
  const double length = blend_length(from, to);
  return [&from, &to, length](double s, Vec2& derivative) {
    const double f = std::clamp(s / length, 0.0, 1.0), c = std::cos(half_pi * f), w = c * c;
    const ChainPoint a = from.at(f), b = to.at(f);
    const double slope = -half_pi * std::sin(pi * f);
    derivative =
        (w * from.length() * a.tangent + (1 - w) * to.length() * b.tangent + slope * (a.position - b.position)) /
        length;
    if (f == 0) return a.position;
    if (f == 1) return b.position;
    return w * a.position + (1 - w) * b.position;
  };
}

double turn_of_blend(const FieldEvaluator& evaluator, const Chain& from, const Chain& to) {
  const CurveFunction curve = blended_curve(from, to);
  std::vector<Vec2> places, directions;
  std::vector<double> guides;
  for (int i = 1; i < num_samples; ++i) {
    const double f = static_cast<double>(i) / num_samples, c = std::cos(half_pi * f), w = c * c;
    Vec2 along;
    places.push_back(curve(blend_length(from, to) * f, along));
    directions.push_back(along);
    guides.push_back(angle_of(w * from.at(f).tangent + (1 - w) * to.at(f).tangent));
  }
  const std::vector<PointSample> samples = evaluator.values_at(places);
  double turn = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (samples[i].at.elem < 0) continue;
    const Vec2 field = unit(guided_angle(samples[i].value, guides[i]));
    turn = std::max(turn, std::abs(std::atan2(cross(field, directions[i]), dot(field, directions[i]))));
  }
  return turn;
}

std::optional<Blend> make_blend(const FieldEvaluator& evaluator, const CurveTable& table, const Pieces& from,
                                const Pieces& to, const BlendOptions& options) {
  const Chain a(table, from), b(table, to);
  const double turn = turn_of_blend(evaluator, a, b);
  if (turn > options.max_turn) return std::nullopt;
  return Blend{from, to, fit_line(blended_curve(a, b), blend_length(a, b), options.fit_tol), turn};
}

std::optional<Nurbs> find_blend(const std::vector<Blend>& blends, const Pieces& from, const Pieces& to) {
  const auto starts_alike = [](const ArcPiece& p, const ArcPiece& q) { return p.curve == q.curve && p.t0 == q.t0; };
  const auto ends_alike = [](const ArcPiece& p, const ArcPiece& q) { return p.curve == q.curve && p.t1 == q.t1; };
  const Pieces back_from = reversed_pieces(to), back_to = reversed_pieces(from);
  for (const Blend& blend : blends) {
    if (starts_alike(blend.from.front(), from.front()) && ends_alike(blend.to.back(), to.back())) return blend.spline;
    if (starts_alike(blend.from.front(), back_from.front()) && ends_alike(blend.to.back(), back_to.back()))
      return reversed(blend.spline);
  }
  return std::nullopt;
}

bool cross_chain(const Nurbs& spline, const Chain& chain, double& s, double& fraction) {
  const double scale = spline.end() - spline.begin();
  for (int i = 0; i < 50; ++i) {
    const ChainPoint on = chain.at(fraction);
    const Vec2 gap = point(spline, s) - on.position, ds = derivative(spline, s), dt = chain.length() * on.tangent;
    const double area = cross(ds, dt);
    if (area == 0) return false;
    // gap + ds * step_s - dt * step_t = 0
    const double step_s = -cross(gap, dt) / area, step_t = -cross(gap, ds) / area;
    s = std::clamp(s + step_s, spline.begin(), spline.end());
    fraction = std::clamp(fraction + step_t, 0.0, 1.0);
    if (std::abs(step_s) <= 1e-14 * scale && std::abs(step_t) <= 1e-14) break;
  }
  const bool meets = distance(point(spline, s), chain.at(fraction).position) <= 1e-12 * scale;
  return meets && s > spline.begin() && s < spline.end() && fraction > 0 && fraction < 1;
}

}  // namespace quadrille
