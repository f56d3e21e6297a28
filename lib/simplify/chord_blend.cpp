#include "simplify/chord_blend.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::simplify {
namespace {

constexpr int num_samples = 64;

}  // namespace

double blend_length(const curve::Chain& from, const curve::Chain& to) { return (from.length() + to.length()) / 2; }

curve::CurveFunction blended_curve(const curve::Chain& from, const curve::Chain& to) {
  const double length = blend_length(from, to);
  return [&from, &to, length](double s, Vec2& derivative) {
    const double f = std::clamp(s / length, 0.0, 1.0), c = std::cos(half_pi * f), w = c * c;
    const curve::ChainPoint a = from.at(f), b = to.at(f);
    const double slope = -half_pi * std::sin(pi * f);
    derivative =
        (w * from.length() * a.tangent + (1 - w) * to.length() * b.tangent + slope * (a.position - b.position)) /
        length;
    if (f == 0) return a.position;
    if (f == 1) return b.position;
    return w * a.position + (1 - w) * b.position;
  };
}

double deviation_of_blend(const field::FieldEvaluator& evaluator, const curve::Chain& from, const curve::Chain& to) {
  const curve::CurveFunction curve = blended_curve(from, to);
  std::vector<Vec2> positions, directions;
  std::vector<double> guides;
  for (int i = 1; i < num_samples; ++i) {
    const double f = static_cast<double>(i) / num_samples, c = std::cos(half_pi * f), w = c * c;
    Vec2 along;
    positions.push_back(curve(blend_length(from, to) * f, along));
    directions.push_back(along);
    guides.push_back(angle_of(w * from.at(f).tangent + (1 - w) * to.at(f).tangent));
  }
  const std::vector<field::PointSample> samples = evaluator.values_at(positions);
  double deviation = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (samples[i].at.elem < 0) continue;
    const Vec2 field = unit(guided_angle(samples[i].value, guides[i]));
    deviation = std::max(deviation, std::abs(std::atan2(cross(field, directions[i]), dot(field, directions[i]))));
  }
  return deviation;
}

std::optional<Blend> make_blend(const field::FieldEvaluator& evaluator, const curve::CurveTable& table,
                                const graph::Pieces& from, const graph::Pieces& to, const BlendOptions& options) {
  const curve::Chain a(table, from), b(table, to);
  const double deviation = deviation_of_blend(evaluator, a, b);
  if (deviation > options.max_deviation) return std::nullopt;
  return Blend{from, to, curve::fit_line(blended_curve(a, b), blend_length(a, b), options.fit_tol), deviation};
}

std::optional<Nurbs> find_blend(const std::vector<Blend>& blends, const graph::Pieces& from, const graph::Pieces& to) {
  const auto starts_alike = [](const ArcPiece& p, const ArcPiece& q) { return p.curve == q.curve && p.t0 == q.t0; };
  const auto ends_alike = [](const ArcPiece& p, const ArcPiece& q) { return p.curve == q.curve && p.t1 == q.t1; };
  const graph::Pieces back_from = graph::reversed_pieces(to), back_to = graph::reversed_pieces(from);
  for (const Blend& blend : blends) {
    if (starts_alike(blend.from.front(), from.front()) && ends_alike(blend.to.back(), to.back())) return blend.spline;
    if (starts_alike(blend.from.front(), back_from.front()) && ends_alike(blend.to.back(), back_to.back()))
      return curve::reversed(blend.spline);
  }
  return std::nullopt;
}

bool cross_chain(const Nurbs& spline, const curve::Chain& chain, double& s, double& fraction) {
  const double scale = spline.end() - spline.begin();
  for (int i = 0; i < 50; ++i) {
    const curve::ChainPoint on = chain.at(fraction);
    const Vec2 gap = curve::point(spline, s) - on.position, ds = curve::derivative(spline, s),
               dt = chain.length() * on.tangent;
    const double area = cross(ds, dt);
    if (area == 0) return false;
    // gap + ds * step_s - dt * step_t = 0
    const double step_s = -cross(gap, dt) / area, step_t = -cross(gap, ds) / area;
    s = std::clamp(s + step_s, spline.begin(), spline.end());
    fraction = std::clamp(fraction + step_t, 0.0, 1.0);
    if (std::abs(step_s) <= 1e-14 * scale && std::abs(step_t) <= 1e-14) break;
  }
  const bool meets = distance(curve::point(spline, s), chain.at(fraction).position) <= 1e-12 * scale;
  return meets && s > spline.begin() && s < spline.end() && fraction > 0 && fraction < 1;
}

}  // namespace quadrille::simplify
