#include "couple/couple_layouts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/position_text.hpp"
#include "couple/continue_lines.hpp"
#include "couple/interface_corner.hpp"
#include "couple/join_layouts.hpp"
#include "couple/meet_stations.hpp"
#include "couple/periodic_layout.hpp"
#include "couple/periodic_nodes.hpp"
#include "couple/turn_round_regions.hpp"
#include "curve/chain.hpp"
#include "graph/face_corners.hpp"
#include "layout/certificate.hpp"
#include "layout/choose_layout.hpp"
#include "model/periodic_arcs.hpp"
#include "quantize/extend_lines.hpp"
#include "quantize/quantize.hpp"
#include "quantize/t_mesh_faces.hpp"
#include "simplify/simplify.hpp"

namespace quadrille::couple {
namespace {

constexpr double relative_unit = 0.1;  // an arc of this length, relative to the diameter, has integer length one

// With blocks worse than the first, lines follow the field across whole regions if that makes better ones, and not
// more; with blocks worse than the second also if it makes more.
constexpr double good_scaled_jacobian = 0.7, acceptable_scaled_jacobian = 0.5;

constexpr double equal_quality = 1e-6;

constexpr int max_rounds = 8;  // of lines continued from one region into the next

std::vector<double> arc_lengths(const ArcGraph& graph) {
  const curve::CurveTable table(graph.face, graph.splines);
  std::vector<double> lengths;
  for (const GraphArc& arc : graph.arcs) lengths.push_back(curve::Chain(table, arc.pieces).length());
  return lengths;
}

[[noreturn]] void fail_to_continue(const CadFace& face) {
  if (face.num_regions() > 1)
    throw ComputeError(
        "the lines of the regions cannot be continued across their interfaces: a strip of blocks winds onto itself; "
        "mesh the regions alone (cad2tri --face)");
  std::string remedy;
  if (const auto corner = sharpest_interface_corner(face))
    remedy =
        fmt::format(", round the corner of the curve at {}, where it turns by {:.0f} degrees",
                    rounded_position_text(face.joints[corner->joint].position + face.origin), degrees(corner->turn));
  throw ComputeError(
      "the lines on both sides of an embedded curve or of periodic sides cannot be continued across: a strip of blocks "
      "winds onto itself; choose other nodes (critpoints --nodes, --topology)" +
      remedy + ", or leave the curve out");
}

graph::CandidateLayout conforming(const graph::CandidateLayout& t_mesh) {
  const ArcGraph& graph = t_mesh.graph();
  const std::vector<quantize::TFace> faces = quantize::t_mesh_faces(t_mesh.subdivision);
  const quantize::Quantization found =
      quantize::quantize_or_explain(faces, arc_lengths(graph), relative_unit * graph.face.diameter);
  if (found.lengths.empty()) fail_to_continue(graph.face);
  return quantize::extend_lines(t_mesh, faces, found.lengths);
}

// The deviation of continued lines is that from the field of the region through which each runs.
void certify(const field::FieldsOfRegions& fields, graph::CandidateLayout& layout, Report& report) {
  double& deviation = layout.certificate.largest_deviation_degrees;
  deviation = std::max(deviation, degrees(layout::deviation_of_extended_lines(fields, layout)));
  layout::certify(*layout.certificate.method, layout, report);
}

graph::CandidateLayout coupled(RegionLayouts regions, Reach reach, const layout::LayoutOptions& options,
                               Report& report) {
  report.set("couple.turned_regions", turn_round_regions(regions));
  int num_met = 0, num_continued = 0;
  for (const CutEnds cuts : {CutEnds::ignored, CutEnds::included}) {
    num_met += meet_stations(regions, cuts);
    for (int round = 0; round < max_rounds; ++round) {
      const int num = continue_lines(regions, cuts, reach);
      if (num == 0) break;
      num_continued += num;
      num_met += meet_stations(regions, cuts);
    }
    if (cuts == CutEnds::ignored) remove_needless_cuts(regions);
  }
  report.set("couple.lines_met", num_met);
  report.set("couple.lines_continued", num_continued);
  const field::FieldsOfRegions fields(regions.fields, regions.turns);
  SeparatrixGraph joined = join_layouts(regions);
  const bool is_periodic = !joined.face.periodic_pairs.empty();
  if (is_periodic) snap_periodic_nodes(joined);
  graph::CandidateLayout layout = graph::candidate_layout(std::move(joined));
  report.set("couple.t_junctions", layout.t_junctions.size());
  report.set("couple.faces_before", layout.subdivision.num_faces());
  if (is_periodic)
    layout = conforming_across_periodic_sides(std::move(layout), fields, relative_unit, report);
  else if (!layout.t_junctions.empty())
    layout = conforming(layout);
  graph::require_four_corners(layout.subdivision);
  if (options.simplify != layout::SimplifyLevel::none)
    layout = simplify::simplify(fields, std::move(layout), layout::simplify_options(options), report);
  report.set("couple.faces", layout.subdivision.num_faces());
  graph::require_drawn_in_order(layout.subdivision);
  require_periodic_arcs(layout.graph(), "leave out --simplify, or the pair (cad2tri --periodic)");
  certify(fields, layout, report);
  return layout;
}

// Integer lengths move lines by up to the unit, far more than the distance of lines that run close to each other.
void follow_field_if_better(RegionLayouts regions, const layout::LayoutOptions& options, graph::CandidateLayout& layout,
                            Report& report) {
  const layout::LayoutQuality before = layout::quality_of(layout.subdivision);
  const double quality = before.is_valid ? before.least_scaled_jacobian : 0;
  if (quality >= good_scaled_jacobian) return;
  Report attempt_report(report.progress());
  try {
    graph::CandidateLayout attempt = coupled(std::move(regions), Reach::region, options, attempt_report);
    const layout::LayoutQuality after = layout::quality_of(attempt.subdivision);
    if (!after.is_valid || after.least_scaled_jacobian <= quality + equal_quality) return;
    if (quality >= acceptable_scaled_jacobian && after.num_blocks > before.num_blocks) return;
    layout = std::move(attempt);
  } catch (const ComputeError&) {
    return;
  }
  for (const auto& [key, value] : attempt_report.entries()) report.set(key, value);
}

}  // namespace

SeparatrixGraph couple_layouts(RegionLayouts regions, const layout::LayoutOptions& options, Report& report) {
  graph::CandidateLayout layout = coupled(regions, Reach::first_line, options, report);
  follow_field_if_better(std::move(regions), options, layout, report);
  return graph::separatrix_graph(std::move(layout));
}

}  // namespace quadrille::couple
