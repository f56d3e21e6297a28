#include "sew/match_curves.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "curve/nurbs.hpp"
#include "curve/pole_box.hpp"
#include "curve/project.hpp"
#include "outline/extent.hpp"

namespace quadrille::sew {
namespace {

constexpr int samples_per_span = 6;

/// Curves by the places of their starts and ends; (-1, -1): smooth closed curves.
using ByEnds = std::map<std::pair<int, int>, std::vector<CurveId>>;

std::pair<int, int> ends_of(const Placed& placed, CurveId id) {
  const std::vector<int>& places = placed.places[id.region];
  return {places[id.curve], places[placed.regions[id.region].next_in_loop(id.curve)]};
}

const Nurbs& curve_of(const Placed& placed, CurveId id) { return placed.regions[id.region].curves[id.curve].curve; }

ByEnds curves_by_ends(const Placed& placed) {
  ByEnds result;
  for (int r = 0; r < static_cast<int>(placed.regions.size()); ++r)
    for (int c = 0; c < placed.regions[r].num_curves(); ++c)
      if (placed.regions[r].other_sides[c] < 0) result[ends_of(placed, {r, c})].push_back({r, c});
  return result;
}

/// Whether closed curves run in opposite directions; others between the same places do so in any case.
bool are_opposite(const Nurbs& a, const Nurbs& b, bool are_closed) {
  return !are_closed || outline::signed_area({a}) * outline::signed_area({b}) < 0;
}

bool may_meet(const Nurbs& a, const Nurbs& b, double tol) {
  const curve::PoleBox p = curve::pole_box(a), q = curve::pole_box(b);
  return p.low.x <= q.high.x + tol && q.low.x <= p.high.x + tol && p.low.y <= q.high.y + tol &&
         q.low.y <= p.high.y + tol;
}

}  // namespace

double one_sided_separation(const Nurbs& a, const Nurbs& b) {
  double greatest = 0;
  for (size_t k = 1; k < a.knots.size(); ++k) {
    const double t0 = a.knots[k - 1], t1 = a.knots[k];
    for (int i = 0; i <= samples_per_span && t0 < t1; ++i)
      greatest = std::max(greatest, curve::project(b, curve::point(a, t0 + (t1 - t0) * i / samples_per_span)).distance);
  }
  return greatest;
}

double separation(const Nurbs& a, const Nurbs& b) {
  return std::max(one_sided_separation(a, b), one_sided_separation(b, a));
}

Matched match_curves(const Placed& placed, double tol) {
  const ByEnds curves = curves_by_ends(placed);
  Matched matched{by_curve(placed.regions, CurveId()), 0};
  const auto partner = [&](CurveId id) -> CurveId& { return matched.partners[id.region][id.curve]; };
  for (int r = 0; r < static_cast<int>(placed.regions.size()); ++r)
    for (int c = 0; c < placed.regions[r].num_curves(); ++c) {
      const CurveId a{r, c};
      const auto [from, to] = ends_of(placed, a);
      const auto opposite = curves.find({to, from});
      if (placed.regions[r].other_sides[c] >= 0 || opposite == curves.end()) continue;
      for (const CurveId b : opposite->second) {
        if (partner(a).exists() || b.region <= r || partner(b).exists()) continue;
        const Nurbs &p = curve_of(placed, a), &q = curve_of(placed, b);
        if (!may_meet(p, q, tol) || !are_opposite(p, q, from == to)) continue;
        const double apart = separation(p, q);
        if (!(apart <= tol)) continue;
        partner(a) = b, partner(b) = a;
        matched.greatest = std::max(matched.greatest, apart);
      }
    }
  return matched;
}

}  // namespace quadrille::sew
