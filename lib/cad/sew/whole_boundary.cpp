#include "sew/whole_boundary.hpp"

#include "base/disjoint_sets.hpp"

namespace quadrille::sew {

std::vector<std::vector<CurveId>> whole_boundary(const Sewn& sewn) {
  const auto partner = [&](CurveId id) { return sewn.partners[id.region][id.curve]; };
  const auto after = [&](CurveId id) { return CurveId{id.region, sewn.regions[id.region].next_in_loop(id.curve)}; };
  ByCurve<bool> is_done = by_curve(sewn.regions, false);
  std::vector<std::vector<CurveId>> loops;
  for (int r = 0; r < static_cast<int>(sewn.regions.size()); ++r)
    for (int c = 0; c < sewn.regions[r].num_curves(); ++c) {
      if (is_done[r][c] || partner({r, c}).exists()) continue;
      loops.emplace_back();
      for (CurveId id{r, c}; !is_done[id.region][id.curve];) {
        is_done[id.region][id.curve] = true;
        loops.back().push_back(id);
        id = after(id);
        while (partner(id).exists()) id = after(partner(id));
      }
    }
  return loops;
}

std::vector<std::vector<int>> connected_regions(const Sewn& sewn) {
  DisjointSets sets(sewn.regions.size());
  for (int r = 0; r < static_cast<int>(sewn.regions.size()); ++r)
    for (const CurveId partner : sewn.partners[r])
      if (partner.exists()) sets.unite(r, partner.region);
  return sets.sets();
}

}  // namespace quadrille::sew
