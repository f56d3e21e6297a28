#include "sew/face_of_regions.hpp"

#include <algorithm>
#include <utility>

#include "base/angle.hpp"
#include "base/assign_names.hpp"
#include "outline/face_of_loops.hpp"

namespace quadrille::sew {
namespace {

/// Both sides of a common curve with one name.
std::vector<heal::LoopCurve> named_curves(const Sewn& sewn, int r) {
  std::vector<heal::LoopCurve> curves = sewn.regions[r].curves;
  for (size_t c = 0; c < curves.size(); ++c) {
    const CurveId partner = sewn.partners[r][c];
    if (!partner.exists()) continue;
    const std::string& other = sewn.regions[partner.region].curves[partner.curve].name;
    const bool is_first = std::pair(r, static_cast<int>(c)) < std::pair(partner.region, partner.curve);
    if (curves[c].name.empty() || (!is_first && !other.empty())) curves[c].name = other;
  }
  return curves;
}

std::vector<heal::Loop> all_loops(const Sewn& sewn) {
  std::vector<heal::Loop> loops;
  for (int r = 0; r < static_cast<int>(sewn.regions.size()); ++r) {
    const std::vector<heal::LoopCurve> curves = named_curves(sewn, r);
    const std::vector<int>& offsets = sewn.regions[r].loop_offsets;
    for (size_t l = 0; l + 1 < offsets.size(); ++l)
      loops.emplace_back(curves.begin() + offsets[l], curves.begin() + offsets[l + 1]);
  }
  return loops;
}

std::vector<Nurbs> outlines_of(const Sewn& sewn) {
  std::vector<Nurbs> curves;
  for (const Region& region : sewn.regions)
    for (int c = 0; c < region.loop_offsets[1]; ++c) curves.push_back(region.curves[c].curve);
  return curves;
}

std::vector<int> partner_numbers(const Sewn& sewn) {
  std::vector<int> first{0}, numbers;
  for (const Region& region : sewn.regions) first.push_back(first.back() + region.num_curves());
  for (const auto& partners : sewn.partners)
    for (const CurveId id : partners) numbers.push_back(id.exists() ? first[id.region] + id.curve : -1);
  return numbers;
}

/// At the tip of a slit the curve turns back: all around it is the face.
void open_tips(CadFace& face) {
  for (int j = 0; j < face.num_curves(); ++j)
    if (face.partners[j] == face.previous_in_loop(j)) {
      face.joints[j].interior_angle = 2 * pi;
      face.joints[j].is_corner = true;
    }
}

}  // namespace

CadFace face_of_regions(const Sewn& sewn, const heal::RawFace& raw, double corner_angle) {
  CadFace face = outline::face_of_loops(raw, all_loops(sewn), outlines_of(sewn), corner_angle);
  face.partners = partner_numbers(sewn);
  face.region_loops = {0};
  for (const Region& region : sewn.regions) {
    face.region_loops.push_back(face.region_loops.back() + region.num_loops());
    face.region_names.push_back(region.name);
  }
  for (const int r : replace_empty_names(face.region_names, "region"))
    if (r > 0 && sewn.regions[r - 1].cad_face == sewn.regions[r].cad_face)  // a face that inner curves divide
      face.region_names[r] = face.region_names[r - 1];
  open_tips(face);
  if (sewn.regions.size() > 1) return face;
  face.name = sewn.regions.front().name;
  face.region_loops.clear(), face.region_names.clear();
  if (sewn.num_inner_curves == 0) face.partners.clear();
  return face;
}

}  // namespace quadrille::sew
