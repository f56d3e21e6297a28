#include "sew/region.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "curve/nurbs.hpp"

namespace quadrille::sew {
namespace {

int loop_of(const Region& region, int curve) {
  const auto& offsets = region.loop_offsets;
  return static_cast<int>(std::upper_bound(offsets.begin(), offsets.end(), curve) - offsets.begin()) - 1;
}

}  // namespace

int Region::next_in_loop(int curve) const {
  const int l = loop_of(*this, curve);
  return curve + 1 < loop_offsets[l + 1] ? curve + 1 : loop_offsets[l];
}

int Region::previous_in_loop(int curve) const {
  const int l = loop_of(*this, curve);
  return curve > loop_offsets[l] ? curve - 1 : loop_offsets[l + 1] - 1;
}

Region region_of(const std::vector<heal::Loop>& loops, const std::string& name, int cad_face) {
  Region region{name, cad_face, {}, {}, {0}};
  for (const heal::Loop& loop : loops) {
    region.curves.insert(region.curves.end(), loop.begin(), loop.end());
    region.loop_offsets.push_back(region.num_curves());
  }
  region.other_sides.assign(region.curves.size(), -1);
  return region;
}

bool has_seam(const Region& region, int curve) {
  return region.next_in_loop(curve) == curve && curve::has_smooth_seam(region.curves[curve].curve);
}

std::string face_text(const Region& region) {
  return region.name.empty() ? fmt::format("face {}", region.cad_face)
                             : fmt::format("face {} '{}'", region.cad_face, region.name);
}

curve::PoleBox region_box(const Region& region) {
  curve::PoleBox box = curve::pole_box(region.curves.front().curve);
  for (int c = 1; c < region.loop_offsets[1]; ++c) box.extend(curve::pole_box(region.curves[c].curve));  // the outline
  return box;
}

std::vector<std::vector<Nurbs>> loop_curves(const Region& region) {
  std::vector<std::vector<Nurbs>> loops;
  for (int l = 0; l < region.num_loops(); ++l) {
    loops.emplace_back();
    for (int c = region.loop_offsets[l]; c < region.loop_offsets[l + 1]; ++c)
      loops.back().push_back(region.curves[c].curve);
  }
  return loops;
}

}  // namespace quadrille::sew
