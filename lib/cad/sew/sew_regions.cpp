#include "sew/sew_regions.hpp"

#include <algorithm>

#include "curve/nurbs.hpp"
#include "sew/match_curves.hpp"
#include "sew/places.hpp"

namespace quadrille::sew {
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
