// Chooses the irregular nodes of the layout and the valences of the corners from a guiding field.

#include <fmt/format.h>

#include <utility>

#include "base/counted.hpp"
#include "base/error.hpp"
#include "check/check.hpp"
#include "choice/choose_nodes.hpp"
#include "cli/tool_main.hpp"
#include "features/automatic_size.hpp"
#include "field/error_estimate.hpp"
#include "guide/override_corners.hpp"
#include "io/output_file.hpp"
#include "io/stage_files.hpp"
#include "regions/join.hpp"
#include "regions/region_numbers.hpp"
#include "regions/region_work.hpp"
#include "regions/split.hpp"
#include "topology/grid_kind.hpp"

using namespace quadrille;

namespace {

/// The options in the form of the command line.
struct NodeArguments {
  choice::NodeOptions options;
  std::vector<std::string> corner_valences;
  std::string feature_size = "auto";
  std::vector<std::string> clearances;

  std::vector<placement::NamedClearance> named_clearances() const {
    std::vector<placement::NamedClearance> named;
    for (const std::string& text : clearances) named.push_back(placement::parse_clearance(text));
    return named;
  }

  choice::NodeOptions parsed() const {
    choice::NodeOptions result = options;
    for (const std::string& text : corner_valences) result.overrides.push_back(guide::parse_corner_override(text));
    result.feature_size = features::parse_feature_size(feature_size);
    return result;
  }
};

void declare(Options& o, NodeArguments& arguments) {
  choice::NodeOptions& options = arguments.options;
  o.number("--cluster-distance", options.search.cluster_distance, 0, 0.1, "diameters",
           "zeros nearer to each other than this form one cluster, which is replaced by one node or a symmetric set of "
           "nodes, or cancels; so do zeros of opposite index nearer to each other than 0.4 of their distance to the "
           "boundary, if fewer nodes can replace them; 0: only zeros that cannot be distinguished");
  o.number("--corner-absorb", options.search.corner_absorb, 0, 0.1, "diameters",
           "corners absorb zeros nearer than this where the new valence is admissible; 0: none");
  o.integer("--max-valence", options.max_valence, 5, 12,
            "clusters that would need a node of greater valence are split");
  o.texts("--corner-valence", arguments.corner_valences, "A:B=V",
          "prescribes V blocks at the corner where the boundary curves A and B meet");
  o.choice("--ties", options.ties,
           "corners within 2 degrees of 45, 135, 225 or 315 degrees: choose their valences by rule, the same on both "
           "sides of the tie; or those of the field, which may not decide them");
  o.choice("--degenerate", options.degenerate,
           "corners too sharp for a block: divide them by a node of valence 3 (midpoint division), or keep them: then "
           "there is no layout");
  o.text("--feature-size", arguments.feature_size, "auto|L",
         "nodes forced by fillets and holes smaller than this length move onto the boundary or away from it, or "
         "cancel; auto: diameter / 500 (in a far field, of the box around the bodies), or half the mean width of the "
         "face if that is less; 0: they stay (unit: file units; default: auto)");
  o.choice("--nodes", options.nodes,
           "irregular nodes inside: those of the field; the fewest that the index sum requires for these corner "
           "valences, all of one sign; none: corner valences change too, to blocks of 40 to 140 degrees there, so that "
           "no node is required, or as few as possible; auto: fewest if --topology makes a C-, O- or H-grid, and "
           "between walls and curves of cad2tri --offset, else field. The fewest nodes are placed at the least energy");
  o.choice(
      "--topology", options.topology,
      "grid around the holes. c: blocks leave with the wake, of more than two corners of the outline those that are "
      "not downstream of its centre have two blocks; o: blocks close around the holes, all corners of the outline have "
      "two blocks; h: blocks pass; "
      "auto: by a far field, an outline whose curves are all called farfield, o if it has no corner and one "
      "body inside, c with two corners, h with four; none: as in any face");
  o.choice(
      "--layer-corners", options.layer_corners,
      "layers between a body and its curve of cad2tri --offset. pass: blocks go on beyond the corners of the body, "
      "with right angles; close: one line at each corner, and blocks close around the body; auto: close around "
      "several bodies, where blocks that pass one would run into another");
  o.choice("--place", options.place,
           "keep nodes at the zeros of the field, or move them to the least energy; nodes of split clusters and those "
           "of --nodes fewest and none are always moved, those of divided corners never");
  o.number("--place-weight", options.placement.weight, 0, 100, "1",
           "weight of the boundary-distance term relative to the energy; 0: the energy alone");
  o.texts(
      "--clearance", arguments.clearances, "NAME=L",
      "nodes nearer to the boundary NAME than L (file units) move the shortest way to the distance L, so that layers "
      "along it fit below them; where there is no room, as far as there is");
}

// What the face alone decides.
void require_face(const CadFace& face, const choice::NodeOptions& options,
                  const std::vector<placement::NamedClearance>& clearances) {
  guide::require_corners(face, options.overrides);
  topology::require_holes(face, options.topology);
  placement::wall_clearances(face, clearances);
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
CriticalPoints chosen(const Field& field, const choice::NodeOptions& options, cli::Session& s) {
  const CadFace& face = field.mesh.face;
  if (face.num_regions() > 1) guide::require_corners(face, options.overrides);
  topology::require_holes(face, options.topology);
  const topology::LayerCorners layer_corners = topology::layer_corners(face, options.layer_corners);
  std::vector<Field> fields = regions::split(field);
  const auto begin_phase = [&](const char* part) {
    if (fields.size() == 1) s.begin_phase(part);
  };
  if (fields.size() > 1) s.begin_phase("choose");
  std::vector<CriticalPoints> parts =
      regions::map_regions<CriticalPoints>(face, s.threads(), s.report(), [&](int region, int threads, Report& report) {
        Field& part = fields[region];
        if (part.elem_error.empty()) part.elem_error = field::error_estimate(part);
        choice::NodeOptions part_options = options;
        part_options.overrides = overrides_in(options.overrides, regions::curves_of(face, region));
        part_options.layer_corners = layer_corners;
        part_options.walls = walls_in(options.walls, regions::curves_of(face, region));
        return choice::choose_nodes(part, part_options, threads, report, begin_phase);
      });
  return regions::join(field.mesh, std::move(parts));
}

}  // namespace

int main(int argc, char** argv) {
  std::string input = "-", output = "-", shape;
  NodeArguments arguments;
  cli::Tool tool;
  tool.name = "critpoints";
  tool.summary = "chooses the irregular nodes of the layout and the valences of the corners";
  tool.description =
      "Reads a field and finds each of its zeros once, with its index and valence, and the valence of every corner. A "
      "proof shows that none is missing: each element is cut into cells until a bound shows that a cell contains no "
      "zero, or at most one, which is then computed. Each zero has an error bar, from the estimated error of the field "
      "there.\n\n"
      "Zeros that no layout can use are replaced: multiple zeros and zeros nearer to each other than any block are "
      "split symmetrically, merged or cancelled; corners absorb adjacent zeros; nodes of small fillets and holes move "
      "onto the boundary or away from it; corner valences may be prescribed, by corner or by the kind of grid around "
      "a body, and the number of nodes reduced to what they require. Where a corner lies within 2 degrees of "
      "45, 135, 225 or 315 degrees, the field does not decide between two valences: they are chosen by rule, and the "
      "nodes are the zeros of the field with its data turned accordingly. Each change is listed in the output with its "
      "reason. Unless \"form\" is \"harmonic\" in the output, the later stages need a field solved for these nodes: "
      "fieldsolve --nodes.\n\n"
      "The sum of 4 - V over the nodes and of 2 - V over the corners must be four times the face's Euler "
      "characteristic (1 less the number of holes); otherwise nothing is written and the exit code is 1.";
  tool.examples = {"critpoints half_disc.field.h5 -o half_disc.crit.json",
                   "critpoints half_disc.field.h5 | jq '.critical_points[] | select(.valence == 3) | .position'",
                   "critpoints --place energy half_disc.field.h5 -o half_disc.placed.crit.json",
                   "critpoints --nodes fewest half_disc.field.h5 -o half_disc.fewest.crit.json",
                   "critpoints --feature-size 0.1 half_disc.field.h5 | jq '.changes'"};
  tool.options = [&](Options& o) {
    o.input("FIELD", input, "field file of padapt or fieldsolve; - is standard input");
    o.output(output, "file of the nodes and corners; - is standard output");
    declare(o, arguments);
    o.hidden_text("--check-shape", shape);
  };
  tool.run = [&](cli::Session& s) {
    choice::NodeOptions options = arguments.parsed();
    const std::vector<placement::NamedClearance> clearances = arguments.named_clearances();
    if (!shape.empty()) return require_face(io::read_face(io::read_input(shape)), options, clearances);
    s.begin_phase("read");
    const io::InputFile file = io::read_input(input);
    const Field field = io::read_field(file);
    check::require_valid(check::check_field(field, check::CheckDepth::quick), file.name);
    if (field.kind != FieldKind::harmonic)
      throw FormatError(file.name +
                        ": the field is of the phase form, solved for given nodes: critpoints reads harmonic fields");
    options.walls = placement::wall_clearances(field.mesh.face, clearances);
    CriticalPoints points = chosen(field, options, s);
    s.begin_phase("write");
    s.report().set("critical_points", points.critical_points.size());
    s.report().set("form", enum_name(points.form));
    s.report().set("changes", points.changes.size());
    s.info(fmt::format("{}, {}, index sum {}, {}, form {}",
                       counted(points.critical_points.size() + points.boundary_nodes.size(), "irregular node"),
                       counted(points.corners.size(), "corner"), points.index_sum,
                       counted(points.changes.size(), "change"), enum_name(points.form)));
    points.provenance = s.provenance(field.provenance, {file.digest("field")});
    io::write_stage(output, points);
  };
  tool.report_writer = io::write_report;
  return cli::tool_main(argc, argv, tool);
}
