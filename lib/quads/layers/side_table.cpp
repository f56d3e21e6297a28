#include "layers/side_table.hpp"

#include <algorithm>
#include <array>

#include "spectral/quadrature.hpp"

namespace quadrille::layers {
namespace {

constexpr int degree = 10;
constexpr double table_tol = 1e-13;
constexpr double least_panel = 1.0 / 4096;

const std::array<double, degree + 1>& barycentric_weights() {
  static const std::array<double, degree + 1> weights = [] {
    const std::vector<double>& x = spectral::gll_points(degree);
    std::array<double, degree + 1> w;
    for (int i = 0; i <= degree; ++i) {
      w[i] = 1;
      for (int k = 0; k <= degree; ++k)
        if (k != i) w[i] /= x[i] - x[k];
    }
    return w;
  }();
  return weights;
}

Vec2 interpolated(const Vec2* points, double xi) {
  const std::vector<double>& x = spectral::gll_points(degree);
  const std::array<double, degree + 1>& w = barycentric_weights();
  Vec2 sum;
  double total = 0;
  for (int i = 0; i <= degree; ++i) {
    if (xi == x[i]) return points[i];
    const double weight = w[i] / (xi - x[i]);
    sum += weight * points[i];
    total += weight;
  }
  return sum / total;
}

}  // namespace

SideTable::SideTable(const curve::Chain& chain, bool backwards) : ends_{0.0} {
  double low = 0;
  std::vector<double> breaks = chain.break_fractions();
  if (backwards) {
    std::reverse(breaks.begin(), breaks.end());
    for (double& f : breaks) f = 1 - f;
  }
  breaks.push_back(1);
  for (const double f : breaks)
    if (f > low) add(chain, backwards, low, f), low = f;
}

void SideTable::add(const curve::Chain& chain, bool backwards, double low, double high) {
  const auto exact = [&](double f) { return chain.at(backwards ? 1 - f : f).position; };
  const std::vector<double>& x = spectral::gll_points(degree);
  std::array<Vec2, degree + 1> points;
  for (int i = 0; i <= degree; ++i) points[i] = exact(low * (1 - x[i]) / 2 + high * (1 + x[i]) / 2);
  double error = 0;
  for (const int i : {0, degree / 2, degree - 1}) {
    const double xi = (x[i] + x[i + 1]) / 2;
    const Vec2 miss = exact(low * (1 - xi) / 2 + high * (1 + xi) / 2) - interpolated(points.data(), xi);
    error = std::max(error, norm(miss));
  }
  if (error > table_tol * chain.length() && high - low > least_panel) {
    add(chain, backwards, low, (low + high) / 2);
    add(chain, backwards, (low + high) / 2, high);
    return;
  }
  ends_.push_back(high);
  points_.insert(points_.end(), points.begin(), points.end());
}

Vec2 SideTable::at(double f) const {
  const std::size_t panel = std::clamp<std::ptrdiff_t>(std::upper_bound(ends_.begin(), ends_.end(), f) - ends_.begin(),
                                                       1, static_cast<std::ptrdiff_t>(ends_.size()) - 1) -
                            1;
  const double xi = 2 * (f - ends_[panel]) / (ends_[panel + 1] - ends_[panel]) - 1;
  return interpolated(&points_[panel * (degree + 1)], std::clamp(xi, -1.0, 1.0));
}

}  // namespace quadrille::layers
