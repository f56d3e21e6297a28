#include "offset/chart_heights.hpp"

#include <algorithm>
#include <cmath>

#include "curve/gauss.hpp"

namespace quadrille::offset {
namespace {

constexpr int most_steps = 60, num_points = 3;  // of Newton's method; of Gauss, as mesh::ChartMap::mean_scale

bool is_isometric(const Chart& chart) {
  return std::ranges::all_of(chart.log_scale, [](double lambda) { return lambda == 0; });
}

}  // namespace

ChartHeights::ChartHeights(const CadFace& face)
    : map_(face.chart && !is_isometric(*face.chart) ? std::make_shared<const mesh::ChartMap>(face) : nullptr) {}

double ChartHeights::scale(Vec2 x, Vec2& gradient) const {
  std::vector<const curve::SymmetryLine*> crossed;
  for (auto line = mirrors_.rbegin(); line != mirrors_.rend(); ++line)
    if (line->height(x) < 0) x = (*line)(x), crossed.push_back(&*line);
  const double result = std::exp(map_->log_scale(x, gradient));
  for (auto line = crossed.rbegin(); line != crossed.rend(); ++line) gradient = (*line)->reflected(gradient);
  return result;
}

double ChartHeights::in_space(const WallFoot& foot, double in_chart) const {
  if (is_planar()) return in_chart;
  Vec2 unused;
  const auto at = [&](double height) { return scale(foot.position + height * foot.normal, unused); };
  return curve::gauss_integral<num_points>(at, 0, in_chart);
}

// Newton's method; the integral grows with the height.
double ChartHeights::in_chart(const WallFoot& foot, double in_space) const {
  if (is_planar()) return in_space;
  Vec2 unused;
  double height = in_space / scale(foot.position, unused);
  for (int step = 0; step < most_steps; ++step) {
    const double missing = in_space - this->in_space(foot, height);
    const double next = height + missing / scale(foot.position + height * foot.normal, unused);
    const double move = std::abs(next - height);
    height = std::max(next, height / 2);
    if (move <= 1e-15 * height) break;
  }
  return height;
}

double ChartHeights::slope_in_chart(const WallFoot& foot, double curvature, double in_chart, double slope) const {
  if (is_planar()) return slope;
  const Vec2 tangent{foot.normal.y, -foot.normal.x};
  // The integral's derivatives as the foot moves, and by the height.
  const auto rates = [&](double u) {
    Vec2 gradient;
    const double at = scale(foot.position + u * in_chart * foot.normal, gradient);
    return Vec2{at * in_chart * (1 - curvature * u * in_chart) * dot(gradient, tangent),
                at * (1 + u * in_chart * dot(gradient, foot.normal))};
  };
  const Vec2 rate = curve::gauss_integral<num_points>(rates, 0, 1);
  return (slope - rate.x) / rate.y;
}

}  // namespace quadrille::offset
