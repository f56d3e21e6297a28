#include "stage/critpoints.hpp"

#include <fmt/format.h>

#include <utility>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/options.hpp"
#include "check/check.hpp"
#include "curve/symmetry_lines.hpp"
#include "features/small_features.hpp"
#include "field/error_estimate.hpp"
#include "guide/override_corners.hpp"
#include "placement/keep_clearance.hpp"
#include "regions/region_work.hpp"
#include "regions/split.hpp"
#include "stage/symmetry_option.hpp"
#include "topology/grid_kind.hpp"

namespace quadrille::stage {

namespace {

// The texts of the options as what they mean; the walls are those of a face.
choice::NodeOptions parsed(const CritpointsOptions& options) {
  choice::NodeOptions result = options.choose;
  for (const std::string& text : options.corner_valences)
    result.overrides.push_back(guide::parse_corner_override(text));
  result.feature_size = features::parse_feature_size(options.feature_size);
  return result;
}

std::vector<placement::NamedClearance> named_clearances(const CritpointsOptions& options) {
  std::vector<placement::NamedClearance> named;
  for (const std::string& text : options.clearances) named.push_back(placement::parse_clearance(text));
  return named;
}

// Those between curves of the region, which count from 0 there.
std::vector<guide::CornerOverride> overrides_in(const std::vector<guide::CornerOverride>& overrides,
                                                regions::IndexRange curves) {
  std::vector<guide::CornerOverride> part;
  for (guide::CornerOverride override : overrides) {
    if (!curves.contains(override.curve_a) || !curves.contains(override.curve_b)) continue;
    override.curve_a -= curves.begin;
    override.curve_b -= curves.begin;
    part.push_back(override);
  }
  return part;
}

// Those along curves of the region, which count from 0 there.
std::vector<placement::WallClearance> walls_in(const std::vector<placement::WallClearance>& walls,
                                               regions::IndexRange curves) {
  std::vector<placement::WallClearance> part;
  for (const placement::WallClearance& wall : walls) {
    placement::WallClearance own{{}, wall.clearance};
    for (const int curve : wall.curves)
      if (curves.contains(curve)) own.curves.push_back(curve - curves.begin);
    if (!own.curves.empty()) part.push_back(own);
  }
  return part;
}

// The nodes of each region. Phases of the work are timed only where there is one region.
CriticalPoints chosen(const Field& field, const choice::NodeOptions& options, Run& run) {
  const CadFace& face = field.mesh.face;
  if (face.num_regions() > 1) guide::require_corners(face, options.overrides);
  const CadFace whole = curve::whole_of(face, options.symmetry);
  topology::require_holes(whole, options.topology);
  const topology::LayerCorners layer_corners = topology::layer_corners(whole, options.layer_corners);
  std::vector<Field> fields = regions::split(field);
  const auto begin_phase = [&](const char* part) {
    if (fields.size() == 1) run.begin_phase(part);
  };
  if (fields.size() > 1) run.begin_phase("choose");
  std::vector<CriticalPoints> parts = regions::map_regions<CriticalPoints>(
      face, run.threads(), run.report(), [&](int region, int threads, Report& report) {
        Field& part = fields[region];
        if (part.elem_error.empty()) part.elem_error = field::error_estimate(part);
        choice::NodeOptions part_options = options;
        part_options.overrides = overrides_in(options.overrides, regions::curves_of(face, region));
        part_options.layer_corners = layer_corners;
        if (fields.size() > 1 || !options.symmetry.empty()) part_options.found.reset();  // other fields
        part_options.walls = walls_in(options.walls, regions::curves_of(face, region));
        return choice::choose_nodes(part, part_options, threads, report, begin_phase);
      });
  return regions::join(field.mesh, std::move(parts));
}

void report_points(const CriticalPoints& points, Run& run) {
  run.report().set("critical_points", points.critical_points.size());
  run.report().set("form", enum_name(points.form));
  run.report().set("changes", points.changes.size());
  run.info(fmt::format("{}, {}, index sum {}, {}, form {}",
                       counted(points.critical_points.size() + points.boundary_nodes.size(), "irregular node"),
                       counted(points.corners.size(), "corner"), points.index_sum,
                       counted(points.changes.size(), "change"), enum_name(points.form)));
}

}  // namespace

void CritpointsOptions::validate() const {
  parsed(*this);
  named_clearances(*this);
}

void declare(Options& o, CritpointsOptions& critpoints) {
  o.number("--cluster-distance", critpoints.choose.search.cluster_distance, 0, 0.1, "diameters",
           "zeros nearer to each other than this form one cluster, which is replaced by one node or a symmetric set of "
           "nodes, or cancels; so do zeros of opposite index nearer to each other than 0.4 of their distance to the "
           "boundary, if fewer nodes can replace them; 0: only zeros that cannot be distinguished");
  o.number("--corner-absorb", critpoints.choose.search.corner_absorb, 0, 0.1, "diameters",
           "corners absorb zeros nearer than this where the new valence is admissible; 0: none");
  o.integer("--max-valence", critpoints.choose.max_valence, 5, 12,
            "clusters that would need a node of greater valence are split");
  o.texts("--corner-valence", critpoints.corner_valences, "A:B=V",
          "prescribes V blocks at the corner where the boundary curves A and B meet");
  o.choice("--ties", critpoints.choose.ties,
           "corners within 2 degrees of 45, 135, 225 or 315 degrees: choose their valences by rule, the same on both "
           "sides of the tie; or those of the field, which may not decide them");
  o.choice("--degenerate", critpoints.choose.degenerate,
           "corners too sharp for a block: divide them by a node of valence 3 (midpoint division), or keep them: then "
           "there is no layout");
  o.text("--feature-size", critpoints.feature_size, "auto|L",
         "nodes forced by fillets and holes smaller than this length move onto the boundary or away from it, or "
         "cancel; auto: diameter / 500 (in a far field, of the box around the bodies), or half the mean width of the "
         "face if that is less; 0: they stay (unit: file units; default: auto)");
  o.choice("--nodes", critpoints.choose.nodes,
           "irregular nodes inside: those of the field; the fewest that the index sum requires for these corner "
           "valences, all of one sign; none: corner valences change too, to blocks of 40 to 140 degrees there, so that "
           "no node is required, or as few as possible; auto: fewest if --topology makes a C-, O- or H-grid, and "
           "between walls and curves of cad2tri --offset, else field. The fewest nodes are placed at the least energy");
  o.choice(
      "--topology", critpoints.choose.topology,
      "grid around the holes. c: blocks leave with the wake, of more than two corners of the outline those that are "
      "not downstream of its centre have two blocks; o: blocks close around the holes, all corners of the outline have "
      "two blocks; h: blocks pass; auto: by a far field, an outline whose curves are all called farfield, o if it has "
      "no corner and one body inside, c with two corners, h with four; none: as in any face");
  declare_symmetry(o, critpoints.symmetry);
  o.choice("--layer-corners", critpoints.choose.layer_corners,
           "layers between a body and its curve of cad2tri --offset. pass: blocks go on beyond the corners of the "
           "body, with right angles; close: one line at each corner, and blocks close around the body; auto: close "
           "around several bodies, where blocks that pass one would run into another");
  o.choice("--place", critpoints.choose.place,
           "keep nodes at the zeros of the field, or move them to the least energy; nodes of split clusters and those "
           "of --nodes fewest and none are always moved, those of divided corners never, and none at zeros that follow "
           "prescribed directions (fieldsolve --align)");
  o.number("--place-weight", critpoints.choose.placement.weight, 0, 100, "1",
           "weight of the boundary-distance term relative to the energy; 0: the energy alone");
  o.texts("--clearance", critpoints.clearances, "NAME=L",
          "nodes nearer to the boundary NAME than L (file units, on a curved face in space) move the shortest way to "
          "the distance L, so that layers along it fit below them; where there is no room, as far as there is");
}

CriticalPoints critpoints(const Input<Field>& input, const CritpointsOptions& options, Run& run) {
  require_intervals(options);
  choice::NodeOptions choosing = parsed(options);
  const Field& field = input.model;
  check::require_sound(field, input.file.name);
  if (field.kind != FieldKind::harmonic)
    throw FormatError(input.file.name +
                      ": the field is of the phase form, solved for given nodes: critpoints reads harmonic fields");
  choosing.symmetry = checked_symmetry(field.mesh.face, options.symmetry, run.report());
  choosing.walls = placement::wall_clearances(field.mesh.face, named_clearances(options));
  CriticalPoints points = chosen(field, choosing, run);
  if (points.face.chart) {  // large, and whoever reads nodes also reads a field or triangles that have it
    points.face.chart.reset();
    points.face.periodic_pairs.clear();  // whose motions are in space
  }
  run.end_phase();
  report_points(points, run);
  points.provenance = with_step(field.provenance, "critpoints", options, {input.file.digest("field")});
  return points;
}

void require_critpoints_of(const CadFace& face, const CritpointsOptions& options) {
  require_intervals(options);
  guide::require_corners(face, parsed(options).overrides);
  Report not_yet;
  const std::vector<std::string> symmetry = checked_symmetry(face, options.symmetry, not_yet);
  topology::require_holes(curve::whole_of(face, symmetry), options.choose.topology);
  placement::wall_clearances(face, named_clearances(options));
}

}  // namespace quadrille::stage
