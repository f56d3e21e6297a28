#include "chart/inner_images.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/angle.hpp"
#include "chart/chart_outline.hpp"
#include "chart/smooth_parameters.hpp"
#include "chart/space_length.hpp"
#include "mesh/chart_map.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::chart {
namespace {

constexpr int least_samples = 24, most_samples = 192;  // between two knots, and of a curve without inner knots

/// The image of one curve, by the points of the chart that are nearest in space.
class CurveImage {
 public:
  CurveImage(const mesh::ChartMap& map, const SpaceCurve& curve) : map_(map), curve_(curve), length_(curve) {}

  CurveSamples samples() const {
    std::vector<double> breaks{curve_.begin()};
    for (const double knot : curve_.knots)
      if (knot > breaks.back()) breaks.push_back(knot);
    const int spans = static_cast<int>(breaks.size()) - 1, n = std::max(least_samples, most_samples / spans);
    CurveSamples result;
    result.points.push_back({breaks.front(), at(breaks.front())});
    for (std::size_t b = 1; b < breaks.size(); ++b) {
      const double low = length_.at(breaks[b - 1]), high = length_.at(breaks[b]);
      for (int i = 1; i < n; ++i) {
        const double t = length_.parameter(low + (1 - std::cos(pi * i / n)) / 2 * (high - low));
        result.points.push_back({t, at(t)});
      }
      result.points.push_back({breaks[b], at(breaks[b])});
    }
    result.start_derivative = derivative(result.points.front(), false);
    result.end_derivative = derivative(result.points.back(), true);
    return result;
  }

  double length() const { return length_.total(); }

 private:
  Vec2 at(double t) const { return map_.nearest(surface::point(curve_, t)).x; }

  // The chart keeps angles: its two derivatives in space are orthogonal.
  Vec2 derivative(const curve::FitPoint& end, bool at_end) const {
    const Vec3 in_space = surface::derivatives(curve_, end.parameter, at_end)[1];
    const auto [x, y] = map_.derivatives(end.position);
    return {dot(in_space, x) / norm2(x), dot(in_space, y) / norm2(y)};
  }

  const mesh::ChartMap& map_;
  const SpaceCurve& curve_;
  SpaceLength length_;
};

/// The plane is mapped by a motion, which maps poles.
Nurbs moved_image(const mesh::ChartMap& map, const CadFace& face, const SpaceCurve& curve) {
  const Chart& chart = *face.chart;
  const Vec3 origin = chart.space_nodes.front();
  const auto [x, y] = map.derivatives(chart.nodes.front());
  Nurbs image{curve.degree, curve.knots, {}, curve.weights};
  for (const Vec3& pole : curve.poles)
    image.poles.push_back(chart.nodes.front() + Vec2{dot(pole - origin, x), dot(pole - origin, y)});
  return image;
}

}  // namespace

std::vector<ImagedCurve> inner_curves_in_chart(const SpaceFace& space_face, const CadFace& face) {
  std::vector<ImagedCurve> curves;
  if (space_face.inner_curves.empty()) return curves;
  const mesh::ChartMap map(face);
  const bool is_planar = face.chart->closedness == 0;
  const double tolerance = outline_tolerance(face.chart->closedness);
  for (const InnerSpaceCurve& inner : space_face.inner_curves) {
    if (is_planar) {
      curves.push_back({inner.curve, moved_image(map, face, inner.curve)});
      continue;
    }
    ImagedCurve curve{with_smooth_parameters(inner.curve), {}};
    const CurveImage image(map, curve.space);
    curve.image = fitted_curve(curve.space, image.samples(), tolerance * std::min(face.diameter, image.length()));
    curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace quadrille::chart
