#include "couple/couple_layouts.hpp"

#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/tolerance.hpp"
#include "couple/conforming_layout.hpp"
#include "couple/continue_lines.hpp"
#include "couple/join_layouts.hpp"
#include "couple/rotate_circular_regions.hpp"
#include "couple/side_pairs.hpp"
#include "graph/candidate_layout.hpp"
#include "layout/certificate.hpp"
#include "layout/choose_layout.hpp"
#include "layout/midpoint_layout.hpp"
#include "model/periodic.hpp"
#include "regions/split.hpp"
#include "simplify/simplify.hpp"

namespace quadrille::couple {
namespace {

// With blocks worse than the first, lines follow the field across whole regions if that makes better ones, and not
// more; with blocks worse than the second also if it makes more.
constexpr double good_scaled_jacobian = 0.7, acceptable_scaled_jacobian = 0.5;

constexpr int max_rounds = 8;  // of lines continued from one region into the next

// Lines of the regions that end on interfaces match lines of the other side, or are continued there.
void continue_across_interfaces(RegionLayouts& regions, ContinueTo limit, double most_bend, Report& report) {
  int num_matched = 0, num_continued = 0;
  const auto match = [&](CutEnds cuts) {
    num_matched += match_line_ends(regions, interface_sides(regions, cuts), most_bend);
  };
  for (const CutEnds cuts : {CutEnds::ignored, CutEnds::included}) {
    match(cuts);
    for (int round = 0; round < max_rounds; ++round) {
      const int num = continue_lines(regions, cuts, limit);
      if (num == 0) break;
      num_continued += num;
      match(cuts);
    }
    if (cuts == CutEnds::ignored) remove_needless_cuts(regions);
  }
  report.set("couple.lines_met", num_matched);
  report.set("couple.lines_continued", num_continued);
}

graph::CandidateLayout coupled(RegionLayouts regions, ContinueTo limit, const layout::LayoutOptions& options,
                               Report& report, double most_bend = greatest_bend) {
  report.set("couple.turned_regions", rotate_circular_regions(regions));
  continue_across_interfaces(regions, limit, most_bend, report);
  SeparatrixGraph joined = join_layouts(regions);
  snap_periodic_nodes(joined);
  graph::CandidateLayout layout = graph::candidate_layout(std::move(joined));
  report.set("couple.t_junctions", layout.t_junctions.size());
  report.set("couple.faces_before", layout.subdivision.num_faces());
  layout = conforming_layout(regions, std::move(layout), report);
  const field::FieldsOfRegions fields(regions.fields, regions.rotations);
  graph::require_four_corners(layout.subdivision);
  if (options.simplify != layout::SimplifyLevel::none)
    layout = simplify::simplify(fields, std::move(layout), layout::simplify_options(options), report);
  report.set("couple.faces", layout.subdivision.num_faces());
  graph::require_drawn_in_order(layout.subdivision);
  require_periodic_arcs(layout.graph(), "leave out --simplify, or the pair (cad2tri --periodic)");
  layout::certify(fields, *layout.certificate.method, layout, report);
  return layout;
}

// Lines that end far from each other on the two sides of an interface may wind around a hole without end: they become
// one then, although that bends them more. No value if that gives no valid blocks either.
std::optional<graph::CandidateLayout> coupled_with_bends(const RegionLayouts& regions,
                                                         const layout::LayoutOptions& options, Report& report) {
  try {
    graph::CandidateLayout layout = coupled(regions, ContinueTo::first_line, options, report, greatest_forced_bend);
    if (layout::quality_of(layout.subdivision).is_valid) return layout;
  } catch (const ComputeError&) {
    return std::nullopt;
  }
  return std::nullopt;
}

graph::CandidateLayout coupled_at_any_bend(const RegionLayouts& regions, const layout::LayoutOptions& options,
                                           Report& report) {
  try {
    return coupled(regions, ContinueTo::first_line, options, report);
  } catch (const ComputeError&) {
    std::optional<graph::CandidateLayout> bent = coupled_with_bends(regions, options, report);
    if (!bent) throw;
    return std::move(*bent);
  }
}

// Integer lengths move lines by up to the unit, far more than the distance of lines that run close to each other.
void follow_field_if_better(RegionLayouts regions, const layout::LayoutOptions& options, graph::CandidateLayout& layout,
                            Report& report) {
  const layout::LayoutQuality before = layout::quality_of(layout.subdivision);
  const double quality = before.is_valid ? before.least_scaled_jacobian : 0;
  if (quality >= good_scaled_jacobian) return;
  Report attempt_report(report.progress());
  try {
    graph::CandidateLayout attempt = coupled(std::move(regions), ContinueTo::boundary, options, attempt_report);
    const layout::LayoutQuality after = layout::quality_of(attempt.subdivision);
    if (!after.is_valid || after.least_scaled_jacobian <= quality + tolerance::tied) return;
    if (quality >= acceptable_scaled_jacobian && after.num_blocks > before.num_blocks) return;
    layout = std::move(attempt);
  } catch (const ComputeError&) {
    return;
  }
  for (const auto& [key, value] : attempt_report.entries()) report.set(key, value);
}

// Nodes on interfaces are those of the triangles on both sides, so that none is a T-junction.
graph::CandidateLayout joined_division(const CadFace& face, const TriMesh& triangles) {
  RegionLayouts regions{face, {}, {}, {}};
  const std::vector<TriMesh> parts = regions::split(triangles);
  for (std::size_t r = 0; r < parts.size(); ++r) {
    regions.layouts.push_back(graph::candidate_layout(layout::divide_triangles(parts[r]).graph));
    regions.first_curves.push_back(regions::curves_of(triangles.face, static_cast<int>(r)).begin);
  }
  return graph::candidate_layout(join_layouts(regions));
}

}  // namespace

SeparatrixGraph couple_layouts(RegionLayouts regions, const layout::LayoutOptions& options, Report& report) {
  const CadFace& face = regions.face;
  if (face.partners.empty() && face.periodic_pairs.empty())
    return graph::separatrix_graph(std::move(regions.layouts.front()));
  graph::CandidateLayout layout = coupled_at_any_bend(regions, options, report);
  follow_field_if_better(std::move(regions), options, layout, report);
  return graph::separatrix_graph(std::move(layout));
}

SeparatrixGraph midpoint_regions(const CadFace& face, const TriMesh& mesh, const layout::CoarseMesher& mesher,
                                 const std::string& reason, Report& report) {
  graph::CandidateLayout layout;
  if (face.partners.empty()) {
    layout = layout::midpoint_layout(mesh, mesher, report);
  } else {
    layout = joined_division(face, layout::coarse_triangles(mesh.face, mesher, report));
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
