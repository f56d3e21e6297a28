// Traces the separatrices of a guiding field and writes the planar graph of separatrices and boundary.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "check/check.hpp"
#include "cli/tool_main.hpp"
#include "couple/couple_layouts.hpp"
#include "couple/midpoint_regions.hpp"
#include "couple/open_curves.hpp"
#include "field/check_nodes_match_field.hpp"
#include "graph/open_interfaces.hpp"
#include "io/output_file.hpp"
#include "io/stage_files.hpp"
#include "layout/compute_layout.hpp"
#include "regions/region_numbers.hpp"
#include "regions/region_work.hpp"
#include "regions/split.hpp"
#include "topology/grid_kind.hpp"

using namespace quadrille;

namespace {

struct Settings {
  std::string field, points = "-", output = "-";
  std::string checked_points;  ///< of --check-nodes
  layout::LayoutOptions options;
  std::vector<std::string> open, interfaces;  // names of curves
};

/// The curves of --open and --interface in a face.
class OpenCurves {
 public:
  OpenCurves(const CadFace& face, const Settings& settings)
      : face_(face),
        with_open_interfaces_(
            couple::with_open_curves(face, couple::nonconforming_interfaces(settings.interfaces), "--interface")) {
    const CadFace with_cracks = couple::with_open_curves(face, settings.open, "--open");
    for (int c = 0; c < face.num_curves(); ++c)
      is_crack_.push_back(face.is_interface(c) && with_cracks.partners[c] < 0);
  }

  /// Open interfaces have no partners.
  const CadFace& with_open_interfaces() const { return with_open_interfaces_; }

  /// A crack is opened last, so that its sides have nodes in the same places.
  void open_cracks(SeparatrixGraph& graph) const {
    graph.face = face_;
    for (int c = 0; c < face_.num_curves(); ++c)
      if (is_crack_[c] || (face_.is_interface(c) && !with_open_interfaces_.is_interface(c)))
        graph.open_curves.push_back(c);
    graph::open_interfaces(graph, is_crack_);
  }

 private:
  const CadFace& face_;
  CadFace with_open_interfaces_;
  std::vector<bool> is_crack_;
};

/// Midpoint division, if that is chosen or there is no other way.
SeparatrixGraph layout_of_triangles(const TriMesh& mesh, const Settings& settings, cli::Session& session) {
  const OpenCurves open(mesh.face, settings);
  session.begin_phase("divide");
  SeparatrixGraph graph =
      couple::layout_without_field(open.with_open_interfaces(), mesh, settings.options.layout, session.report());
  open.open_cracks(graph);
  return graph;
}

/// Without a field there are no separatrices.
SeparatrixGraph layout_of_triangle_file(const io::InputFile& file, const Settings& settings, cli::Session& session) {
  const TriMesh mesh = io::read_tri_mesh(file);
  check::require_valid(check::check_tri_mesh(mesh, check::CheckDepth::quick), file.name);
  SeparatrixGraph graph = layout_of_triangles(mesh, settings, session);
  graph.provenance = session.provenance(mesh.provenance, {file.digest("tri-mesh")});
  return graph;
}

/// A field and its regions.
struct RegionFields {
  explicit RegionFields(const Field& field) : whole(field), parts(regions::split(field)) {
    for (const Field& part : parts)
      evaluators.push_back(std::make_unique<field::FieldEvaluator>(part, field::FarTerms::expanded));
  }

  const Field& whole;
  std::vector<Field> parts;
  std::vector<std::unique_ptr<field::FieldEvaluator>> evaluators;  // of the parts
};

/// The critical points of each region.
std::vector<CriticalPoints> read_points_of(const RegionFields& fields, const io::InputFile& field_file,
                                           const io::InputFile& file) {
  const Field& field = fields.whole;
  const CriticalPoints points = io::read_critical_points(file);
  check::require_valid(check::check_critical_points(points, check::CheckDepth::quick), file.name);
  // A file of another field refers to elements and corners that this one does not have: then the origin is the cause. A
  // phase that was solved for other nodes of the same face does not have this file in its provenance either: the
  // message that states the remedy must be the first.
  const bool is_phase = field.kind == FieldKind::phase;
  const std::vector<check::Violation> violations = check::check_critical_points_of(points, field);
  if (!is_phase || !violations.empty()) io::require_same_origin(field_file, field.provenance, file, points.provenance);
  check::require_valid(violations, file.name);
  std::vector<CriticalPoints> parts = regions::split(points, field.mesh);
  for (std::size_t r = 0; r < parts.size(); ++r) field::check_nodes_match_field(*fields.evaluators[r], parts[r]);
  if (is_phase) io::require_same_origin(field_file, field.provenance, file, points.provenance);
  return parts;
}

// The layout of each region, and from them that of the whole.
SeparatrixGraph layout_of_regions(const RegionFields& fields, const std::vector<CriticalPoints>& points,
                                  const Settings& settings, cli::Session& session) {
  const CadFace& face = fields.whole.mesh.face;
  const OpenCurves open(face, settings);
  std::vector<SeparatrixGraph> graphs = regions::map_regions<SeparatrixGraph>(
      face, session.threads(), session.report(), [&](int region, int, Report& report) {
        return layout::compute_layout(*fields.evaluators[region], points[region], settings.options, report);
      });
  session.begin_phase("couple");
  couple::RegionLayouts layouts{open.with_open_interfaces(), {}, {}, {}};
  for (int r = 0; r < face.num_regions(); ++r) {
    layouts.layouts.push_back(graph::candidate_layout(std::move(graphs[r])));
    layouts.fields.push_back(fields.evaluators[r].get());
    layouts.first_curves.push_back(regions::curves_of(face, r).begin);
  }
  SeparatrixGraph graph =
      couple::couple_or_divide(std::move(layouts), fields.whole.mesh, settings.options, session.report());
  open.open_cracks(graph);
  return graph;
}

/// Around bodies in a far field other grids may give a layout.
void propose_other_grids(const CadFace& face, const SeparatrixGraph& graph, Report& report) {
  if (graph.certificate.method != LayoutMethod::midpoint) return;
  std::vector<std::string> options;
  for (const topology::GridKind grid : topology::other_grids(face))
    options.push_back(fmt::format("--topology {}", enum_name(grid)));
  if (!options.empty()) report.set("other_grids", fmt::format("{}", fmt::join(options, ", ")));
}

SeparatrixGraph layout_of_field(const io::InputFile& field_file, const Settings& settings, cli::Session& session) {
  const Field field = io::read_field(field_file);
  check::require_valid(check::check_field(field, check::CheckDepth::quick), field_file.name);
  if (settings.options.layout == layout::LayoutChoice::midpoint) {  // needs no nodes
    SeparatrixGraph graph = layout_of_triangles(field.mesh, settings, session);
    graph.provenance = session.provenance(field.provenance, {field_file.digest("field")});
    return graph;
  }
  const io::InputFile points_file = io::read_input(settings.points);
  const RegionFields fields(field);
  const std::vector<CriticalPoints> points = read_points_of(fields, field_file, points_file);
  session.begin_phase("trace");
  SeparatrixGraph graph = layout_of_regions(fields, points, settings, session);
  propose_other_grids(field.mesh.face, graph, session.report());
  graph.provenance =
      session.provenance(field.provenance, {field_file.digest("field"), points_file.digest("critical-points")});
  return graph;
}

/// Whether these are nodes of this field: quadmesh solves for another one if they are not.
void check_nodes(const io::InputFile& field_file, const std::string& points) {
  const Field field = io::read_field(field_file);
  read_points_of(RegionFields(field), field_file, io::read_input(points));
}

}  // namespace

int main(int argc, char** argv) {
  Settings settings;
  layout::LayoutOptions& options = settings.options;
  cli::Tool tool;
  tool.name = "separatrix";
  tool.summary = "traces the separatrices of a guiding field";
  tool.description =
      "Starts a separatrix in each direction of the cross at the irregular nodes and corners of CRIT, traces it "
      "through FIELD to the boundary, merges separatrices that meet head-on and writes the planar graph of "
      "separatrices and boundary. If the nodes of CRIT are not the zeros of the field, FIELD must be the phase that "
      "fieldsolve --nodes solved for them. Every face of the graph must have four corners; otherwise the exit code is "
      "1 and the message names the position, unless --layout auto or midpoint divides triangles into blocks instead, "
      "which need no field. If the face has several regions, lines go on at a right angle in the neighbouring region, "
      "and the graph is that of the whole face.";
  tool.examples = {
      "separatrix half_disc.field.h5 half_disc.crit.json -o half_disc.sep.json",
      "critpoints half_disc.field.h5 | separatrix half_disc.field.h5 - | blocksplit -o half_disc.blocks.h5",
      "separatrix --layout midpoint half_disc.tri.h5 -o half_disc.sep.json"};
  tool.options = [&](cli::Options& o) {
    o.input("FIELD", settings.field,
            "guiding field (x.field.h5, x.phase.h5 or x.solve.h5), or only triangles (x.tri.h5)", true);
    o.input("CRIT", settings.points,
            "its critical points (x.crit.json); not read with --layout midpoint or for triangles");
    o.output(settings.output, "separatrix graph to write (x.sep.json)");
    o.number("--tolerance", options.trace.tolerance, 1e-14, 1e-3, "diameters",
             "greatest error of one integration step");
    o.choice(
        "--integrator", options.trace.integrator,
        "integrator of the separatrices: Runge-Kutta in reference space with error control, or, for comparison, the "
        "paper's Adams-Bashforth in physical space with a fixed step");
    o.number("--step", options.trace.step, 0, 1e300, "file units",
             "greatest step, 0: diameter / 20; with ab4 the fixed step, 0: diameter / 500");
    o.number("--merge-angle", options.trace.merge_angle, 0, 40, "degrees",
             "merge head-on separatrices if their direction changes by less than this");
    o.number("--merge-distance", options.trace.merge_distance, 0, 1e300, "file units",
             "also merge separatrices that pass within this distance");
    o.choice(
        "--simplify", options.simplify,
        "collapse thin chords: normal, if fewer blocks outweigh the loss of block quality; coarsest, if block quality "
        "stays acceptable and no separatrix deviates from the field by more than 45 degrees");
    o.number("--max-deviation", options.max_deviation, 0, 45, "degrees",
             "greatest deviation of a simplified line from the field");
    o.formerly("--max-turn", "--max-deviation");
    o.choice(
        "--layout", options.layout,
        "traced: separatrices are traced to their ends; quantized: each stops at the first separatrix that crosses it "
        "(motorcycle graph), and an integer program decides how they continue; midpoint: no separatrices, "
        "but new triangles, each divided into three blocks; auto: quantized if traced fails or needs more blocks, "
        "midpoint if both fail, if the layouts of regions cannot be joined or if there is no field; t-mesh: only the "
        "stopped separatrices, no layout");
    o.integer(
        "--max-lines", options.max_lines, 1, 1000000,
        "traced layout: greatest number of arcs into which separatrices cut each other; the search for "
        "crossings ends at ten times as many; auto allows ten times as many of both if there is no quantized layout");
    o.texts("--open", settings.open, "NAME",
            "the embedded curve of this name is open, a crack: its nodes are doubled, one for each side in each place, "
            "but at its ends");
    o.texts("--interface", settings.interfaces, "NAME=nonconforming",
            "no line crosses the interface of this name: the two regions have nodes of their own there");
    o.number("--max-length", options.trace.max_length, 0.01, 1e4, "diameters", "greatest length of a separatrix");
    o.number(
        "--max-total-length", options.trace.max_total_length, 0.01, 1e6, "diameters",
        "traced layout: greatest sum of the lengths of all separatrices; with auto, the quantized layout is computed "
        "if this or --max-lines is exceeded");
    o.integer(
        "--max-line-steps", options.trace.max_steps, 1, 1000000,
        "greatest number of integration steps of a separatrix, in the mean over all (over 100, if there are fewer)");
    o.hidden_text("--check-nodes", settings.checked_points);
  };
  tool.run = [&](cli::Session& s) {
    s.begin_phase("read");
    const io::InputFile file = io::read_input(settings.field);
    if (!settings.checked_points.empty()) return check_nodes(file, settings.checked_points);
    const SeparatrixGraph graph = io::stage_format(file) == "tri-mesh" ? layout_of_triangle_file(file, settings, s)
                                                                       : layout_of_field(file, settings, s);
    s.begin_phase("write");
    io::write_separatrix_graph(settings.output, graph);
    s.end_phase();
  };
  tool.report_writer = io::write_report;
  return cli::tool_main(argc, argv, tool);
}
