#include "sew/sew_regions.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "curve/nurbs.hpp"
#include "curve/pole_box.hpp"
#include "curve/project.hpp"
#include "outline/extent.hpp"
#include "sew/region.hpp"

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

/// Two curves that may be one.
struct Candidate {
  double apart = 0;
  CurveId a, b;
};

/// The nearest to each other first: a layer may be thinner than the tolerance.
std::vector<Candidate> candidates(const Placed& placed, double tol) {
  const ByEnds curves = curves_by_ends(placed);
  std::vector<Candidate> result;
  for (const auto& [ends, of_ends] : curves) {
    const auto opposite = curves.find({ends.second, ends.first});
    if (opposite == curves.end()) continue;
    for (const CurveId a : of_ends)
      for (const CurveId b : opposite->second) {
        if (b.region <= a.region) continue;
        const Nurbs &p = curve_of(placed, a), &q = curve_of(placed, b);
        if (!curve::pole_box(p).meets(curve::pole_box(q), tol) || !are_opposite(p, q, ends.first == ends.second))
          continue;
        if (const double apart = separation(p, q); apart <= tol) result.push_back({apart, a, b});
      }
  }
  const auto key = [](const Candidate& c) { return std::tuple(c.apart, c.a.region, c.a.curve, c.b.region, c.b.curve); };
  std::sort(result.begin(), result.end(), [&](const auto& x, const auto& y) { return key(x) < key(y); });
  return result;
}

}  // namespace

double one_sided_separation(const Nurbs& a, const Nurbs& b) {
  double greatest = 0;
  curve::for_each_span(a, [&](double t0, double t1) {
    for (int i = 0; i <= samples_per_span; ++i)
      greatest = std::max(greatest, curve::project(b, curve::point(a, t0 + (t1 - t0) * i / samples_per_span)).distance);
  });
  return greatest;
}

double separation(const Nurbs& a, const Nurbs& b) {
  return std::max(one_sided_separation(a, b), one_sided_separation(b, a));
}

Matched match_curves(const Placed& placed, double tol) {
  Matched matched{by_curve(placed.regions, CurveId()), 0};
  const auto partner = [&](CurveId id) -> CurveId& { return matched.partners[id.region][id.curve]; };
  for (const Candidate& pair : candidates(placed, tol)) {
    if (partner(pair.a).exists() || partner(pair.b).exists()) continue;
    partner(pair.a) = pair.b, partner(pair.b) = pair.a;
    matched.greatest = std::max(matched.greatest, pair.apart);
  }
  return matched;
}

namespace {

/// Whether the curve is replaced by the reverse of its partner: the partner comes first.
bool yields(CurveId id, CurveId partner) {
  return partner.exists() && (partner.region != id.region ? partner.region < id.region : partner.curve < id.curve);
}

}  // namespace

Sewn sew_regions(const std::vector<Region>& regions, double tol) {
  Placed placed = split_at_places(regions, tol);
  Matched matched = match_curves(placed, tol);
  Sewn sewn{
      placed.regions, std::move(matched.partners), placed.places, std::max(placed.greatest, matched.greatest), 0, 0};
  for (int r = 0; r < static_cast<int>(sewn.regions.size()); ++r)
    for (int c = 0; c < sewn.regions[r].num_curves(); ++c) {
      CurveId& partner = sewn.partners[r][c];
      sewn.num_interfaces += partner.exists() && partner.region > r;
      if (const int side = sewn.regions[r].other_sides[c]; side >= 0) {
        partner = {r, side};
        sewn.num_inner_curves += c < side;
      }
      Nurbs& curve = sewn.regions[r].curves[c].curve;
      curve = yields({r, c}, partner) ? curve::reversed(sewn.regions[partner.region].curves[partner.curve].curve)
                                      : curve_to_places(placed, {r, c});
    }
  return sewn;
}

}  // namespace quadrille::sew
