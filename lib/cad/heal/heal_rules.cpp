#include "heal/heal_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace quadrille::heal {

HealScale heal_scale(const RawFace& raw, double tolerance, double diameter) {
  HealScale scale;
  scale.file = raw.file;
  scale.diameter = diameter;
  const bool is_asked = tolerance >= 0;
  // Two curves that lie within the tolerance of their vertex may be twice as far apart. OpenCASCADE sets the tolerance
  // of a vertex to any gap that it finds, hence the upper bound.
  const double of_shape = std::clamp(2 * std::max(raw.tolerance, raw.shape_tolerance),
                                     heal_rules.default_tolerance * diameter, heal_rules.most_tolerance * diameter);
  scale.tolerance = is_asked ? tolerance * diameter : of_shape;
  scale.most_off_curve = std::max(scale.tolerance, raw.tolerance);
  // A projection to the plane moves nothing in the plane, and the file says that the face is planar.
  scale.most_off_plane = std::max(is_asked ? scale.tolerance : heal_rules.most_tolerance * diameter, raw.tolerance);
  scale.short_fraction = is_asked ? tolerance : heal_rules.default_tolerance;
  scale.rounding = heal_rules.rounding * diameter;
  return scale;
}

std::string remedy(const HealScale& scale, double size) {
  const double fraction = size / scale.diameter;
  if (fraction * 1.1 > heal_rules.most_tolerance)
    return fmt::format(" ({:.2g} diameters; healing moves nothing further than {}): draw it anew", fraction,
                       heal_rules.most_tolerance);
  // Two digits, rounded up.
  const double unit = std::pow(10, std::floor(std::log10(fraction)) - 1);
  return fmt::format(" ({:.2g} diameters; the tolerance is {:.2g}): give --heal-tolerance {:.2g}", fraction,
                     scale.tolerance / scale.diameter, unit * std::ceil(fraction / unit * (1 + 1e-6)));
}

void report_repair(const Repair& repair, size_t number, Report& report) {
  const std::string key = fmt::format("heal.repair.{}.", number);
  report.set(key + "kind", enum_name(repair.kind));
  report.set(key + "edge", repair.cad_edge);
  report.set(key + "position", Report::Value(std::vector<double>{repair.position.x, repair.position.y}));
  report.set(key + "distance", repair.distance);
}

}  // namespace quadrille::heal
