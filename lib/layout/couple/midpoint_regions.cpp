#include "couple/midpoint_regions.hpp"

#include <utility>
#include <vector>

#include "base/error.hpp"
#include "couple/couple_layouts.hpp"
#include "couple/join_layouts.hpp"
#include "graph/face_corners.hpp"
#include "layout/midpoint_layout.hpp"
#include "midpoint/midpoint_graph.hpp"
#include "model/periodic.hpp"
#include "regions/region_numbers.hpp"
#include "regions/split.hpp"

namespace quadrille::couple {
namespace {

// Nodes on interfaces are those of the triangles on both sides, so that none is a T-junction.
graph::CandidateLayout joined_division(const CadFace& face, const TriMesh& triangles) {
  RegionLayouts regions{face, {}, {}, {}};
  const std::vector<TriMesh> parts = regions::split(triangles);
  for (std::size_t r = 0; r < parts.size(); ++r) {
    regions.layouts.push_back(graph::candidate_layout(midpoint::divided(parts[r])));
    regions.first_curves.push_back(regions::curves_of(triangles.face, static_cast<int>(r)).begin);
  }
  return graph::candidate_layout(join_layouts(regions));
}

}  // namespace

SeparatrixGraph midpoint_regions(const CadFace& face, const TriMesh& mesh, const midpoint::CoarseMesher& mesher,
                                 const std::string& reason, Report& report) {
  graph::CandidateLayout layout;
  if (face.partners.empty()) {
    layout = layout::midpoint_layout(mesh, mesher, report);
  } else {
    layout = joined_division(face, midpoint::coarse_triangles(mesh.face, mesher, report));
    report.set("midpoint.blocks", graph::require_four_corners(layout.subdivision));
  }
  require_periodic_arcs(layout.graph(), "leave out the pair (cad2tri --periodic)");
  layout::certify_midpoint(layout, reason, report);
  return graph::separatrix_graph(std::move(layout));
}

SeparatrixGraph layout_without_field(const CadFace& face, const TriMesh& mesh, const layout::LayoutOptions& options,
                                     Report& report) {
  return midpoint_regions(face, mesh, options.coarse_mesher, layout::reason_without_field(options.layout), report);
}

SeparatrixGraph couple_or_divide(RegionLayouts regions, const TriMesh& mesh, const layout::LayoutOptions& options,
                                 Report& report) {
  if (options.layout != layout::LayoutChoice::automatic || !options.coarse_mesher)
    return couple_layouts(std::move(regions), options, report);
  const CadFace face = regions.face;
  try {
    return couple_layouts(std::move(regions), options, report);
  } catch (const ComputeError& error) {
    return midpoint_regions(face, mesh, options.coarse_mesher, error.what(), report);
  }
}

}  // namespace quadrille::couple
