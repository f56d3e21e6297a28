#include "sew/slips.hpp"

#include <algorithm>

#include "curve/arc_length.hpp"
#include "curve/nurbs.hpp"
#include "curve/pole_box.hpp"
#include "curve/project.hpp"

namespace quadrille::sew {
namespace {

constexpr double slip_share = 1e-3;        ///< of the diameter
constexpr double slip_tolerances = 10;     ///< of a tolerance that was given
constexpr double length_share = 1.0 / 50;  ///< of the length of the curve
constexpr int num_samples = 9, least_near = 3;

/// The point of region `other` on the boundary of the whole that is nearest to x, if it is within `most`.
std::optional<MeasuredPlace> nearest_of(const Sewn& sewn, int other, Vec2 x, double most) {
  std::optional<MeasuredPlace> nearest;
  for (int c = 0; c < sewn.regions[other].num_curves(); ++c) {
    const Nurbs& curve = sewn.regions[other].curves[c].curve;
    if (sewn.partners[other][c].exists() || !curve::pole_box(curve).contains(x, most)) continue;
    const auto foot = curve::project(curve, x);
    if (foot.distance <= (nearest ? nearest->size : most)) nearest = {0.5 * (x + foot.position), foot.distance};
  }
  return nearest;
}

/// Between the curve and region `other`; both ends of the curve are measured too.
std::optional<Slip> slip_between(const Sewn& sewn, CurveId id, int other, double most_slip) {
  const Nurbs& curve = sewn.regions[id.region].curves[id.curve].curve;
  const curve::ArcLength length(curve);
  const double most = std::min(most_slip, length_share * length.total());
  Slip slip{id.region, other, {}};
  int num_near = 0;
  for (int i = 0; i <= num_samples + 1; ++i) {
    const Vec2 x = curve::point(curve, length.parameter(length.total() * i / (num_samples + 1)));
    const auto near = nearest_of(sewn, other, x, most);
    num_near += near && 0 < i && i <= num_samples;
    if (near && near->size >= slip.gap.size) slip.gap = *near;
  }
  return num_near >= least_near ? std::optional(slip) : std::nullopt;
}

}  // namespace

double most_slip_of(const heal::HealScale& scale, bool is_asked) {
  return is_asked ? slip_tolerances * scale.tolerance : slip_share * scale.diameter;
}

std::optional<Slip> find_slip(const Sewn& sewn, double most_slip) {
  for (int r = 0; r < static_cast<int>(sewn.regions.size()); ++r)
    for (int c = 0; c < sewn.regions[r].num_curves(); ++c)
      for (int other = 0; other < static_cast<int>(sewn.regions.size()) && !sewn.partners[r][c].exists(); ++other)
        if (other != r)
          if (const auto slip = slip_between(sewn, {r, c}, other, most_slip)) return slip;
  return std::nullopt;
}

}  // namespace quadrille::sew
