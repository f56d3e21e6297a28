#include "sew/slips.hpp"

#include <algorithm>

#include "curve/arc_length.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::sew {
namespace {

constexpr double slip_share = 1e-3;        ///< of the diameter
constexpr double slip_tolerances = 10;     ///< of a tolerance that was given
constexpr double length_share = 1.0 / 50;  ///< of the length of the curve
constexpr int num_samples = 9, least_near = 3;

/// Between the curve and region `other`; both ends of the curve are measured too.
std::optional<Slip> slip_between(const Sewn& sewn, CurveId id, int other, double most_slip) {
  const Nurbs& curve = sewn.regions[id.region].curves[id.curve].curve;
  const curve::ArcLength length(curve);
  const double most = std::min(most_slip, length_share * length.total());
  const curve::CurveTree boundary = boundary_of(sewn.regions[other]);
  const auto is_of_whole = [&](int c) { return !sewn.partners[other][c].exists(); };
  Slip slip{id.region, other, {}};
  int num_near = 0;
  for (int i = 0; i <= num_samples + 1; ++i) {
    const Vec2 x = curve::point(curve, length.parameter(length.total() * i / (num_samples + 1)));
    const curve::NearestPoint foot = boundary.nearest(x, is_of_whole);
    if (foot.distance > most) continue;
    num_near += 0 < i && i <= num_samples;
    if (foot.distance >= slip.gap.size) slip.gap = {0.5 * (x + foot.position), foot.distance};
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
