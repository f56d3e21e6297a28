#include "stage/separatrix.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <utility>

#include "base/error.hpp"
#include "base/options.hpp"
#include "check/check.hpp"
#include "check/same_origin.hpp"
#include "couple/couple_layouts.hpp"
#include "curve/symmetry_lines.hpp"
#include "field/check_nodes_match_field.hpp"
#include "graph/open_interfaces.hpp"
#include "layout/compute_layout.hpp"
#include "regions/region_work.hpp"
#include "regions/split.hpp"
#include "stage/symmetry_option.hpp"
#include "topology/grid_kind.hpp"

namespace quadrille::stage {

namespace {

/// The curves of --open and --interface in a face.
class OpenCurves {
 public:
  OpenCurves(const CadFace& face, const SeparatrixOptions& options)
      : face_(face),
        with_open_interfaces_(
            graph::with_open_curves(face, graph::nonconforming_interfaces(options.interfaces), "--interface")) {
    const CadFace with_cracks = graph::with_open_curves(face, options.open, "--open");
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
SeparatrixGraph divided(const TriMesh& mesh, const SeparatrixOptions& options, Run& run) {
  const OpenCurves open(mesh.face, options);
  run.begin_phase("divide");
  SeparatrixGraph graph = couple::layout_without_field(open.with_open_interfaces(), mesh, options, run.report());
  open.open_cracks(graph);
  run.end_phase();
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

/// The critical points of each region, which are those of the field.
std::vector<CriticalPoints> points_of(const RegionFields& fields, const FileIdentity& field_file,
                                      const Input<CriticalPoints>& points) {
  const Field& field = fields.whole;
  const Provenance& chain = points.model.provenance;
  check::require_sound(points.model, points.file.name);
  // A file of another field refers to elements and corners that this one does not have: then the origin is the cause. A
  // phase that was solved for other nodes of the same face does not have this file in its provenance either: the
  // message that states the remedy must be the first.
  const bool is_phase = field.kind == FieldKind::phase;
  const std::vector<check::Violation> violations = check::check_critical_points_of(points.model, field.mesh);
  if (!is_phase || !violations.empty()) check::require_same_origin(field_file, field.provenance, points.file, chain);
  check::require_valid(violations, points.file.name);
  std::vector<CriticalPoints> parts = regions::split(points.model, field.mesh);
  for (std::size_t r = 0; r < parts.size(); ++r) field::check_nodes_match_field(*fields.evaluators[r], parts[r]);
  if (is_phase) check::require_same_origin(field_file, field.provenance, points.file, chain);
  return parts;
}

// The layout of each region, and from them that of the whole.
SeparatrixGraph layout_of_regions(const RegionFields& fields, const std::vector<CriticalPoints>& points,
                                  const SeparatrixOptions& options, Run& run) {
  const CadFace& face = fields.whole.mesh.face;
  const OpenCurves open(face, options);
  std::vector<SeparatrixGraph> graphs =
      regions::map_regions<SeparatrixGraph>(face, run.threads(), run.report(), [&](int region, int, Report& report) {
        return layout::compute_layout(*fields.evaluators[region], points[region], options, report);
      });
  run.begin_phase("couple");
  couple::RegionLayouts layouts{open.with_open_interfaces(), {}, {}, {}};
  for (int r = 0; r < face.num_regions(); ++r) {
    layouts.layouts.push_back(graph::candidate_layout(std::move(graphs[r])));
    layouts.fields.push_back(fields.evaluators[r].get());
    layouts.first_curves.push_back(regions::curves_of(face, r).begin);
  }
  SeparatrixGraph graph = couple::couple_or_divide(std::move(layouts), fields.whole.mesh, options, run.report());
  open.open_cracks(graph);
  return graph;
}

/// Around bodies in a far field other grids may give a layout.
void propose_other_grids(const CadFace& face, const SeparatrixOptions& separatrix, const SeparatrixGraph& graph,
                         Report& report) {
  if (graph.certificate.method != LayoutMethod::midpoint) return;
  std::vector<std::string> options;
  for (const topology::GridKind grid :
       topology::other_grids(curve::whole_of(face, symmetry_names(face, separatrix.symmetry))))
    options.push_back(fmt::format("--topology {}", enum_name(grid)));
  if (!options.empty()) report.set("other_grids", fmt::format("{}", fmt::join(options, ", ")));
}

}  // namespace

void declare(Options& o, SeparatrixOptions& options) {
  o.number("--tolerance", options.trace.tolerance, 1e-14, 1e-3, "diameters", "greatest error of one integration step");
  o.number("--step", options.trace.step, 0, 1e300, "file units", "greatest step of the integration, 0: diameter / 20");
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
      "crossings ends at ten times as many; auto allows ten times as many of both if there is no quantized layout, or "
      "a poor one");
  o.texts("--open", options.open, "NAME",
          "the embedded curve of this name is open, a crack: its nodes are doubled, one for each side in each place, "
          "but at its ends");
  declare_symmetry(o, options.symmetry);
  o.texts("--interface", options.interfaces, "NAME=nonconforming",
          "no line crosses the interface of this name: the two regions have nodes of their own there");
  o.number("--max-length", options.trace.max_length, 0.01, 1e4, "diameters", "greatest length of a separatrix");
  o.number(
      "--max-total-length", options.trace.max_total_length, 0.01, 1e6, "diameters",
      "traced layout: greatest sum of the lengths of all separatrices; with auto, the quantized layout is computed "
      "if this or --max-lines is exceeded");
  o.integer(
      "--max-line-steps", options.trace.max_steps, 1, 1000000,
      "greatest number of integration steps of a separatrix, in the mean over all (over 100, if there are fewer)");
}

SeparatrixGraph separatrix(const Input<Field>& field, const std::optional<Input<CriticalPoints>>& points,
                           const SeparatrixOptions& options, Run& run) {
  require_intervals(options);
  check::require_sound(field.model, field.file.name);
  std::vector<InputDigest> inputs{field.file.digest("field")};
  SeparatrixGraph graph;
  if (options.layout == layout::LayoutChoice::midpoint) {
    graph = divided(field.model.mesh, options, run);
  } else {
    if (!points) throw UsageError("the layout " + std::string(enum_name(options.layout)) + " needs critical points");
    const RegionFields fields(field.model);
    const std::vector<CriticalPoints> parts = points_of(fields, field.file, *points);
    run.begin_phase("trace");
    graph = layout_of_regions(fields, parts, options, run);
    propose_other_grids(field.model.mesh.face, options, graph, run.report());
    run.end_phase();
    inputs.push_back(points->file.digest("critical-points"));
  }
  graph.provenance = with_step(field.model.provenance, "separatrix", options, std::move(inputs));
  return graph;
}

SeparatrixGraph separatrix(const Input<TriMesh>& triangles, const SeparatrixOptions& options, Run& run) {
  require_intervals(options);
  check::require_sound(triangles.model, triangles.file.name);
  SeparatrixGraph graph = divided(triangles.model, options, run);
  graph.provenance = with_step(triangles.model.provenance, "separatrix", options, {triangles.file.digest("tri-mesh")});
  return graph;
}

std::string reason_to_solve_for(const Input<CriticalPoints>& points, const Input<Field>& field) {
  try {
    points_of(RegionFields(field.model), field.file, points);
  } catch (const check::OtherOriginError& error) {
    return error.what();
  } catch (const field::OtherNodesError& error) {
    return error.what();
  }
  return "";
}

}  // namespace quadrille::stage
