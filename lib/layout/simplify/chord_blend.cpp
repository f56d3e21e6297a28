#include "simplify/chord_blend.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"
#include "graph/crossings.hpp"

namespace quadrille::simplify {
namespace {

constexpr int num_samples = 64;

struct BlendPoint {
  Vec2 position, derivative;  // with respect to f
  Vec2 guide;                 // the blended directions of both chains
};

// Of the blend at fraction f of both lengths.
BlendPoint blend_at(const curve::Chain& from, const curve::Chain& to, double f) {
  const double c = std::cos(half_pi * f), w = c * c, slope = -half_pi * std::sin(pi * f);
  const curve::ChainPoint a = from.at(f), b = to.at(f);
  BlendPoint point;
  point.position = f == 0 ? a.position : f == 1 ? b.position : w * a.position + (1 - w) * b.position;
  point.derivative =
      w * from.length() * a.tangent + (1 - w) * to.length() * b.tangent + slope * (a.position - b.position);
  point.guide = w * a.tangent + (1 - w) * b.tangent;
  return point;
}

}  // namespace

double blend_length(const curve::Chain& from, const curve::Chain& to) { return (from.length() + to.length()) / 2; }

curve::CurveFunction blended_curve(const curve::Chain& from, const curve::Chain& to) {
  return [&from, &to, length = blend_length(from, to)](double s, Vec2& derivative) {
    const BlendPoint point = blend_at(from, to, std::clamp(s / length, 0.0, 1.0));
    derivative = point.derivative / length;
    return point.position;
  };
}

double deviation_of_blend(const field::FieldsOfRegions& fields, const curve::Chain& from, const curve::Chain& to) {
  std::vector<BlendPoint> points;
  std::vector<Vec2> positions;
  for (int i = 1; i < num_samples; ++i) {
    points.push_back(blend_at(from, to, static_cast<double>(i) / num_samples));
    positions.push_back(points.back().position);
  }
  const std::vector<field::PointSample> values = fields.values_at(positions);
  double deviation = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i].at.elem < 0) continue;
    const Vec2 field = unit(guided_angle(values[i].value, angle_of(points[i].guide))), along = points[i].derivative;
    deviation = std::max(deviation, graph::angle_between(field, along));
  }
  return deviation;
}

std::optional<Blend> make_blend(const field::FieldsOfRegions& fields, const curve::CurveTable& table,
                                const graph::Pieces& from, const graph::Pieces& to, const BlendOptions& options) {
  const curve::Chain a(table, from), b(table, to);
  const double deviation = deviation_of_blend(fields, a, b);
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

std::optional<std::vector<RungCrossing>> cross_rungs(const ArcGraph& graph, const std::vector<HalfEdge>& rungs,
                                                     const Nurbs& spline) {
  const curve::CurveTable table(graph.face, graph.splines);
  std::vector<RungCrossing> crossings;
  double s = spline.begin();
  for (std::size_t i = 0; i < rungs.size(); ++i) {
    const curve::Chain chain(table, graph::pieces_along(graph, rungs[i]));
    const double along = static_cast<double>(i + 1) / static_cast<double>(rungs.size() + 1);
    double at = spline.begin() + along * (spline.end() - spline.begin()), fraction = 0.5;
    if (!cross_chain(spline, chain, at, fraction) || at <= s) return std::nullopt;
    crossings.push_back({at, chain.at(fraction)});
    s = at;
  }
  return crossings;
}

}  // namespace quadrille::simplify
