#include <algorithm>
#include <memory>
#include <utility>

#include "outline/extent.hpp"
#include "regions/split.hpp"

namespace quadrille::regions {

namespace {

CadFace part_of_face(const CadFace& face, int region) {
  CadFace part = face;
  const IndexRange loops = loops_of(face, region), curves = curves_of(face, region);
  part.curves = part_of(face.curves, curves);
  part.curve_names = part_of(face.curve_names, curves);
  part.curve_cad_edges = part_of(face.curve_cad_edges, curves);
  part.joints = part_of(face.joints, curves);
  if (face.chart) {
    auto chart = std::make_shared<Chart>(*face.chart);
    chart->space_curves = part_of(face.chart->space_curves, curves);
    part.chart = std::move(chart);
  }
  part.unnamed_curves.clear();
  for (const int c : face.unnamed_curves)
    if (curves.contains(c)) part.unnamed_curves.push_back(c - curves.begin);
  part.loop_offsets.clear();
  for (int l = loops.begin; l <= loops.end; ++l) part.loop_offsets.push_back(face.loop_offsets[l] - curves.begin);
  part.name = face.region_names[region];
  part.region_loops.clear();
  part.region_names.clear();
  part.periodic_pairs.clear();
  part.partners = part_of(face.partners, curves);
  for (int& partner : part.partners) partner = curves.contains(partner) ? partner - curves.begin : -1;
  if (std::all_of(part.partners.begin(), part.partners.end(), [](int p) { return p < 0; })) part.partners.clear();
  const IndexRange outline{0, part.loop_offsets[1]};
  part.diameter = outline::diameter(part_of(part.curves, outline));
  return part;
}

}  // namespace

std::vector<CadFace> split(const CadFace& face) {
  if (face.num_regions() == 1) return {face};
  std::vector<CadFace> parts;
  for (int r = 0; r < face.num_regions(); ++r) parts.push_back(part_of_face(face, r));
  return parts;
}

}  // namespace quadrille::regions
