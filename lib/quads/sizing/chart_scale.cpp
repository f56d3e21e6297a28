#include "sizing/chart_scale.hpp"

#include <algorithm>
#include <cmath>

#include "curve/chain.hpp"
#include "curve/gauss.hpp"
#include "curve/nurbs.hpp"
#include "surface/nurbs_surface.hpp"
#include "surface/space_extent.hpp"

namespace quadrille::sizing {

ChartScale::ChartScale(const CadFace& face)
    : face_(face),
      map_(face_),
      least_(std::exp(*std::ranges::min_element(face.chart->log_scale))),
      gradient_(map_.greatest_gradient()) {}

ChartScale::Place ChartScale::at(Vec2 x) const {
  const mesh::ChartMap::Sample sample = map_.sample(x);
  return {sample.position, std::exp(sample.log_scale)};
}

Vec2 ChartScale::gradient(Vec2 x) const {
  Vec2 gradient;
  map_.log_scale(x, gradient);
  return gradient;
}

double boundary_length(const CadFace& face, int curve) {
  if (!face.chart) return curve::ArcLength(face.curves[curve]).total();
  double length = 0;
  curve::for_each_span(face.curves[curve], [&](double a, double b) {
    const auto speed = [&](double t) { return norm(surface::derivatives(face.chart->space_curves[curve], t)[1]); };
    length += curve::gauss_integral(speed, a, b);
  });
  return length;
}

double diameter_in_space(const CadFace& face) { return face.chart ? surface::diameter(*face.chart) : face.diameter; }

std::shared_ptr<const ChartScale> chart_scale(const CadFace& face) {
  return face.chart ? std::make_shared<const ChartScale>(face) : nullptr;
}

}  // namespace quadrille::sizing
