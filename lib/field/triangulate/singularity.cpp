#include "triangulate/singularity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/angle.hpp"
#include "base/tolerance.hpp"

namespace quadrille::triangulate {
namespace {

struct SingularityConstants {
  double far_field_tol = 1e-10;
  /// Greatest amplitude of a term r^2 log r over the edge of an element: at order 20 the error is then below 1e-8, for
  /// two such ends and with what other elements transmit. Measured on splines through 120, 500 and 2000 points of a
  /// coast: of the elements, 0, 5 and 18 miss that; with 0.2, 16, 125 and 220 do.
  double resolved_amplitude = 0.08;
  /// Fan factor used to decide which of two terms needs more layers.
  double usual_factor = 0.15;
};
constexpr SingularityConstants singularity_constants;

/// The jump of the second derivative of the field's phase, 4 times the tangent's angle, along the boundary.
double phase_bend_jump(const Junction& j) { return 4 * std::abs(j.curvature_slope_out - j.curvature_slope_in); }

Singularity curvature_jump(const Junction& j, double radius) {
  const double jump = 4 * std::abs(j.curvature_out - j.curvature_in) * radius;
  const double slope_jump = phase_bend_jump(j) * radius * radius;
  const Singularity first{1, std::min(1.0, jump)}, second{2, std::min(1.0, slope_jump)};
  return fan_layers(first, singularity_constants.usual_factor) >= fan_layers(second, singularity_constants.usual_factor)
             ? first
             : second;
}

}  // namespace

Singularity junction_singularity(const Junction& junction, double radius) {
  if (junction.has_bridge) return {pi / junction.interior_angle, 1, 1};
  const double exponent = pi / junction.interior_angle, nearest = std::round(exponent);
  const double deviation = std::abs(exponent - nearest);
  // Smaller deviations from an integer are rounding errors of the file; near one the singular term is weak: its
  // amplitude vanishes with the deviation.
  const Singularity angular{exponent, deviation <= tolerance::tied ? 0 : std::min(1.0, 10 * deviation)};
  if (nearest < 1 || deviation >= 0.1) return angular;
  const auto bend_of = [radius](double curvature, double slope) {
    return 4 * (std::abs(curvature) + std::abs(slope) * radius) * radius;
  };
  const double bend = std::max(bend_of(junction.curvature_in, junction.curvature_slope_in),
                               bend_of(junction.curvature_out, junction.curvature_slope_out));
  const Singularity curved =
      nearest == 1 ? curvature_jump(junction, radius) : Singularity{nearest, std::min(1.0, bend)};
  return fan_layers(angular, singularity_constants.usual_factor) >=
                 fan_layers(curved, singularity_constants.usual_factor)
             ? angular
             : curved;
}

int fan_layers(const Singularity& singularity, double factor) {
  const auto [exponent, amplitude, apex_order] = singularity;
  if (exponent <= 0 || amplitude <= 0) return 0;
  const double left = amplitude * amplitude * std::pow(apex_order, -4 * exponent);
  if (left < singularity_constants.far_field_tol) return 0;
  const double layers = std::log(singularity_constants.far_field_tol / left) / (2 * exponent * std::log(factor));
  return std::max(1, static_cast<int>(std::lround(layers)));
}

double greatest_edge_length(const Junction& junction) {
  const double jump = phase_bend_jump(junction);
  const bool is_straight = std::lround(pi / junction.interior_angle) == 1;
  return is_straight && jump > 0 ? std::sqrt(singularity_constants.resolved_amplitude / jump)
                                 : std::numeric_limits<double>::infinity();
}

}  // namespace quadrille::triangulate
