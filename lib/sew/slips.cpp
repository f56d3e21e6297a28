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

/// The point of the boundary of the whole that belongs to another region and is nearest to x, if it is within `most`.
std::optional<Slip> nearest_other(const Sewn& sewn, int own, Vec2 x, double most) {
  std::optional<Slip> nearest;
  for (int r = 0; r < static_cast<int>(sewn.regions.size()); ++r)
    for (int c = 0; c < sewn.regions[r].num_curves(); ++c) {
      const Nurbs& curve = sewn.regions[r].curves[c].curve;
      if (r == own || sewn.partners[r][c].exists() || !curve::pole_box(curve).contains(x, most)) continue;
      const auto foot = curve::project(curve, x);
      if (foot.distance <= (nearest ? nearest->gap.size : most))
        nearest = {own, r, {0.5 * (x + foot.position), foot.distance}};
    }
  return nearest;
}

std::optional<Slip> slip_of(const Sewn& sewn, CurveId id, double most_slip) {
  const Nurbs& curve = sewn.regions[id.region].curves[id.curve].curve;
  const curve::ArcLength length(curve);
  const double most = std::min(most_slip, length_share * length.total());
  std::optional<Slip> widest;
  int near = 0;
  for (int i = 1; i <= num_samples; ++i) {
    const Vec2 x = curve::point(curve, length.parameter(length.total() * i / (num_samples + 1)));
    const auto slip = nearest_other(sewn, id.region, x, most);
    near += slip.has_value();
    if (slip && (!widest || slip->gap.size > widest->gap.size)) widest = slip;
  }
  return near >= least_near ? widest : std::nullopt;
}

}  // namespace

double most_slip_of(const heal::HealScale& scale, bool is_asked) {
  return is_asked ? slip_tolerances * scale.tolerance : slip_share * scale.diameter;
}

std::optional<Slip> find_slip(const Sewn& sewn, double most_slip) {
  for (int r = 0; r < static_cast<int>(sewn.regions.size()); ++r)
    for (int c = 0; c < sewn.regions[r].num_curves(); ++c)
      if (!sewn.partners[r][c].exists())
        if (const auto slip = slip_of(sewn, {r, c}, most_slip)) return slip;
  return std::nullopt;
}

}  // namespace quadrille::sew
