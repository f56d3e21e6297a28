#include "sizing/chart_scale.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "curve/chain.hpp"
#include "curve/gauss.hpp"
#include "curve/nurbs.hpp"
#include "mesh/chart_map.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::sizing {
namespace {

constexpr int cells = 64;  ///< along the longer side
constexpr int margin = 2;  ///< cells beyond the chart
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Cubic weights of four neighbours (Catmull and Rom) at s in [0, 1] between the inner two.
std::array<double, 4> weights(double s) {
  return {s * (-1 + s * (2 - s)) / 2, 1 + s * s * (-5 + 3 * s) / 2, s * (1 + s * (4 - 3 * s)) / 2, s * s * (s - 1) / 2};
}

/// Continues known values by one ring of nodes: the mean of the straight lines through two known neighbours in a row,
/// where there are none of the known neighbours. Returns whether there was anything to continue.
bool continue_outwards(std::vector<double>& values, int nx, int ny) {
  constexpr std::array<std::array<int, 2>, 4> directions{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  const std::vector<double> known = values;
  const auto at = [&](int i, int j) { return i < 0 || j < 0 || i >= nx || j >= ny ? unknown : known[j * nx + i]; };
  bool is_changed = false;
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      if (!std::isnan(at(i, j))) continue;
      double lines = 0, means = 0;
      int num_lines = 0, num_means = 0;
      for (const auto& [di, dj] : directions) {
        const double near = at(i + di, j + dj), far = at(i + 2 * di, j + 2 * dj);
        if (!std::isnan(near)) means += near, ++num_means;
        if (!std::isnan(near) && !std::isnan(far)) lines += 2 * near - far, ++num_lines;
      }
      if (num_means == 0) continue;
      values[j * nx + i] = num_lines > 0 ? lines / num_lines : means / num_means;
      is_changed = true;
    }
  return is_changed;
}

}  // namespace

ChartScale::ChartScale(const CadFace& face) {
  const mesh::ChartMap map(face);
  const std::vector<Vec2>& nodes = face.chart->nodes;
  Vec2 low = nodes.front(), high = low;
  for (const Vec2 x : nodes) {
    low = {std::min(low.x, x.x), std::min(low.y, x.y)};
    high = {std::max(high.x, x.x), std::max(high.y, x.y)};
  }
  grid_.step = std::max(high.x - low.x, high.y - low.y) / cells;
  const auto count = [&](double extent) { return static_cast<int>(std::ceil(extent / grid_.step)) + 1 + 2 * margin; };
  grid_.nx = count(high.x - low.x), grid_.ny = count(high.y - low.y);
  // About the middle: the grid of a symmetric chart is symmetric.
  grid_.lower = (low + high) / 2 - grid_.step / 2 * Vec2{grid_.nx - 1.0, grid_.ny - 1.0};
  for (int j = 0; j < grid_.ny; ++j)
    for (int i = 0; i < grid_.nx; ++i)
      values_.push_back(map.log_scale_inside(grid_.lower + grid_.step * Vec2{1.0 * i, 1.0 * j}).value_or(unknown));
  const std::vector<double> inside = values_;
  for (int k = 0; k <= margin; ++k) continue_outwards(values_, grid_.nx, grid_.ny);
  const auto [least, greatest] = std::minmax_element(face.chart->log_scale.begin(), face.chart->log_scale.end());
  for (double& value : values_) value = std::isnan(value) ? *least : std::clamp(value, *least, *greatest);
  least_ = std::exp(*least);
  for (int j = 0; j + 1 < grid_.ny; ++j)
    for (int i = 0; i + 1 < grid_.nx; ++i) {  // differences from unknown values are no numbers
      const double here = inside[j * grid_.nx + i];
      gradient_ = std::fmax(gradient_, std::abs(inside[j * grid_.nx + i + 1] - here) / grid_.step);
      gradient_ = std::fmax(gradient_, std::abs(inside[(j + 1) * grid_.nx + i] - here) / grid_.step);
    }
}

double ChartScale::at(Vec2 x) const {
  const Vec2 at = (x - grid_.lower) / grid_.step;
  const double i = std::clamp(std::floor(at.x), 1.0, grid_.nx - 3.0),
               j = std::clamp(std::floor(at.y), 1.0, grid_.ny - 3.0);
  const std::array<double, 4> wx = weights(std::clamp(at.x - i, 0.0, 1.0)),
                              wy = weights(std::clamp(at.y - j, 0.0, 1.0));
  double sum = 0;
  for (int l = 0; l < 4; ++l)
    for (int k = 0; k < 4; ++k) sum += wx[k] * wy[l] * log_at(static_cast<int>(i) - 1 + k, static_cast<int>(j) - 1 + l);
  return std::exp(sum);
}

double boundary_length(const CadFace& face, int curve) {
  // The mirror images of a half model's curves have none in space, but the lengths of their originals.
  if (!face.chart || curve >= std::ssize(face.chart->space_curves)) return curve::ArcLength(face.curves[curve]).total();
  double length = 0;
  curve::for_each_span(face.curves[curve], [&](double a, double b) {
    const auto speed = [&](double t) { return norm(surface::derivatives(face.chart->space_curves[curve], t)[1]); };
    length += curve::gauss_integral(speed, a, b);
  });
  return length;
}

std::shared_ptr<const ChartScale> chart_scale(const CadFace& face) {
  return face.chart ? std::make_shared<const ChartScale>(face) : nullptr;
}

}  // namespace quadrille::sizing
