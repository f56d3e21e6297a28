#include "sweep/terrain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/error.hpp"
#include "base/message_text.hpp"

namespace quadrille::sweep {

namespace {

std::vector<double> distinct(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

/// Slopes of the splines along lines of the grid: `stride` between their values, which stand at `at`.
std::vector<double> slopes(const std::vector<double>& values, const std::vector<double>& at, std::size_t stride,
                           std::size_t lines, std::size_t line_stride) {
  std::vector<double> result(values.size());
  for (std::size_t line = 0; line < lines; ++line) {
    std::vector<Vec3> heights;
    for (std::size_t k = 0; k < at.size(); ++k) heights.push_back({values[line * line_stride + k * stride], 0, 0});
    const std::vector<Vec3> of_line = spline_slopes(heights, at);
    for (std::size_t k = 0; k < at.size(); ++k) result[line * line_stride + k * stride] = of_line[k].x;
  }
  return result;
}

/// Of the cubic polynomial on an interval of length h, at the fraction t: weights of the values at both ends, and of
/// the slopes there.
std::array<double, 4> hermite(double t, double h) {
  const double r = 1 - t;
  return {r * r * (1 + 2 * t), t * t * (3 - 2 * t), h * t * r * r, -h * t * t * r};
}

std::size_t interval(const std::vector<double>& ends, double x) {
  return static_cast<std::size_t>(std::upper_bound(ends.begin() + 1, ends.end() - 1, x) - ends.begin()) - 1;
}

}  // namespace

Terrain::Terrain(const std::vector<Vec3>& points, std::string file) : file_(std::move(file)) {
  std::vector<double> xs, ys;
  for (const Vec3 p : points) xs.push_back(p.x), ys.push_back(p.y);
  x_ = distinct(std::move(xs)), y_ = distinct(std::move(ys));
  const std::size_t nx = x_.size(), ny = y_.size();
  const auto require_grid = [&](bool is_grid) {
    if (is_grid) return;
    throw UsageError(
        fmt::format("--terrain {}: {} points are no rectangular grid, which has a height at each pair of its x and y, "
                    "here {} different x and {} different y: interpolate them to one of at least 2 x 2 points first",
                    file_, points.size(), nx, ny));
  };
  require_grid(nx >= 2 && ny >= 2 && points.size() / nx == ny && points.size() % nx == 0);
  std::vector<bool> is_there(nx * ny, false);
  z_.resize(nx * ny);
  const auto place = [](const std::vector<double>& values, double x) {
    return static_cast<std::size_t>(std::lower_bound(values.begin(), values.end(), x) - values.begin());
  };
  for (const Vec3 p : points) {
    const std::size_t at = place(y_, p.y) * nx + place(x_, p.x);
    is_there[at] = true, z_[at] = p.z;
  }
  require_grid(std::ranges::find(is_there, false) == is_there.end());
  zx_ = slopes(z_, x_, 1, ny, nx);
  zy_ = slopes(z_, y_, nx, nx, 1);
  zxy_ = slopes(zx_, y_, nx, nx, 1);
}

double Terrain::height(Vec2 x) const {
  if (!(x.x >= x_.front() && x.x <= x_.back() && x.y >= y_.front() && x.y <= y_.back()))
    throw UsageError(fmt::format("--terrain {}: the face reaches beyond its points, at {}", file_, position_text(x)));
  const std::size_t i = interval(x_, x.x), j = interval(y_, x.y);
  const double hx = x_[i + 1] - x_[i], hy = y_[j + 1] - y_[j];
  const auto wx = hermite((x.x - x_[i]) / hx, hx), wy = hermite((x.y - y_[j]) / hy, hy);
  double sum = 0;
  for (std::size_t b = 0; b < 2; ++b)
    for (std::size_t a = 0; a < 2; ++a) {
      const std::size_t at = (j + b) * x_.size() + i + a;
      sum += wx[a] * (wy[b] * z_[at] + wy[b + 2] * zy_[at]) + wx[a + 2] * (wy[b] * zx_[at] + wy[b + 2] * zxy_[at]);
    }
  return sum;
}

}  // namespace quadrille::sweep
