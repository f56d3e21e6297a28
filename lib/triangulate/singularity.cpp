#include "triangulate/singularity.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"

namespace quadrille::triangulate {
namespace {

constexpr double far_field_tol = 1e-10;
/// Smaller deviations of pi / omega from an integer are rounding errors of the file.
constexpr double integer_tol = 1e-6;
/// Fan factor used to decide which of two terms needs more layers.
constexpr double usual_factor = 0.15;

Singularity curvature_jump(const Junction& j, double radius) {
  const double jump = 4 * std::abs(j.curvature_out - j.curvature_in) * radius;
  const double slope_jump = 4 * std::abs(j.curvature_slope_out - j.curvature_slope_in) * radius * radius;
  const Singularity first{1, std::min(1.0, jump)}, second{2, std::min(1.0, slope_jump)};
  return fan_layers(first, usual_factor) >= fan_layers(second, usual_factor) ? first : second;
}

}  // namespace

Singularity junction_singularity(const Junction& junction, double radius) {
  if (junction.has_bridge) return {pi / junction.interior_angle, 1};
  const double exponent = pi / junction.interior_angle, nearest = std::round(exponent);
  const double deviation = std::abs(exponent - nearest);
  // Near an integer the singular term is weak: its amplitude vanishes with the deviation.
  const Singularity angular{exponent, deviation <= integer_tol ? 0 : std::min(1.0, 10 * deviation)};
  if (nearest < 1 || deviation >= 0.1) return angular;
  const auto bend_of = [radius](double curvature, double slope) {
    return 4 * (std::abs(curvature) + std::abs(slope) * radius) * radius;
  };
  const double bend = std::max(bend_of(junction.curvature_in, junction.curvature_slope_in),
                               bend_of(junction.curvature_out, junction.curvature_slope_out));
  const Singularity curved =
      nearest == 1 ? curvature_jump(junction, radius) : Singularity{nearest, std::min(1.0, bend)};
  return fan_layers(angular, usual_factor) >= fan_layers(curved, usual_factor) ? angular : curved;
}

int fan_layers(const Singularity& singularity, double factor) {
  const auto [exponent, amplitude] = singularity;
  if (exponent <= 0 || amplitude <= 0) return 0;
  const double energy = amplitude * amplitude;
  if (energy * std::pow(8.0, -4 * exponent) < far_field_tol) return 0;
  const double layers = std::log(far_field_tol / energy) / (2 * exponent * std::log(factor));
  return std::max(1, static_cast<int>(std::lround(layers)));
}

}  // namespace quadrille::triangulate
