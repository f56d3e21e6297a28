#include "stage/fieldsolve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/options.hpp"
#include "check/check.hpp"
#include "check/same_origin.hpp"
#include "field/alignment_term.hpp"
#include "field/error_estimate.hpp"
#include "field/misalignment.hpp"
#include "galerkin/phase_request.hpp"
#include "galerkin/solve_phase.hpp"
#include "regions/region_work.hpp"
#include "regions/split.hpp"
#include "stage/given_positions.hpp"

namespace quadrille::stage {

namespace {

// Checks that a field on this mesh can have the nodes. Their element numbers may be those of another mesh.
void require_nodes_of(const Input<CriticalPoints>& nodes, const Input<TriMesh>& mesh) {
  const CriticalPoints& points = nodes.model;
  check::require_sound(points, nodes.file.name);
  std::vector<check::Violation> violations = check::check_critical_points_of(points, mesh.model);
  std::erase_if(violations, [](const check::Violation& violation) { return violation.rule == "CRT-R09"; });
  if (!violations.empty()) check::require_same_origin(mesh.file, mesh.model.provenance, nodes.file, points.provenance);
  check::require_valid(violations, nodes.file.name);
  if (points.origin != mesh.model.face.origin)
    throw FormatError(
        fmt::format("{}: its origin differs from that of the mesh: it belongs to another face", nodes.file.name));
}

/// The field of one region. Of the phase form, the boundary data of its solver serve the error estimate too.
struct SolvedRegion {
  Field field;
  std::unique_ptr<galerkin::PhaseSolver> phase;
};

// `meshes`: of the regions; they must outlive the result.
std::vector<SolvedRegion> solved(const TriMesh& mesh, const std::vector<TriMesh>& meshes, const OrderMap& orders,
                                 const std::optional<Input<CriticalPoints>>& prescribed,
                                 const galerkin::LaplaceOptions& options, Report& report) {
  const std::vector<CriticalPoints> nodes =
      prescribed ? regions::split(prescribed->model, mesh) : std::vector<CriticalPoints>(meshes.size());
  return regions::map_regions<SolvedRegion>(
      mesh.face, options.num_threads, report, [&](int region, int threads, Report& part_report) {
        const std::vector<int> part_orders = regions::part_of(orders.elem_order, regions::elems_of(mesh, region));
        SolvedRegion result;
        if (!prescribed) {
          galerkin::LaplaceOptions part_options = options;
          part_options.num_threads = threads;
          result.field = galerkin::solve_laplace(meshes[region], part_orders, part_options, part_report);
          return result;
        }
        const PhaseNodes phase_nodes = phase_nodes_of(nodes[region]);
        result.phase = std::make_unique<galerkin::PhaseSolver>(
            meshes[region],
            orders.of_harmonic_field ? galerkin::phase_orders(meshes[region], part_orders) : part_orders, threads,
            options.alignment);
        galerkin::require_possible(*result.phase, meshes[region].face, phase_nodes, prescribed->file.name);
        result.field = result.phase->solve(phase_nodes, nodes[region].hole_winding_offsets, part_report);
        return result;
      });
}

// "2 of valence 3, 1 of valence 5"
std::string counts_by_valence(const std::vector<int>& valences) {
  std::map<int, int> counts;
  for (const int valence : valences) ++counts[valence];
  std::vector<std::string> texts;
  for (const auto& [valence, count] : counts) texts.push_back(fmt::format("{} of valence {}", count, valence));
  return fmt::format("{}", fmt::join(texts, ", "));
}

void report_phase(const PhaseForm& phase, Run& run) {
  constexpr std::size_t most_holes = 20;
  std::vector<int> nodes, corners;
  for (const PhaseNode& node : phase.prescribed.nodes) nodes.push_back(node.valence);
  for (const CornerValence& corner : phase.prescribed.corners) corners.push_back(corner.valence);
  run.info(fmt::format("nodes: {}; corners: {}", nodes.empty() ? "none" : counts_by_valence(nodes),
                       corners.empty() ? "none" : counts_by_valence(corners)));
  const std::size_t num_holes = phase.hole_winding.size();
  for (std::size_t j = 0; j < std::min(num_holes, most_holes); ++j)
    run.info(fmt::format("hole {}: winding {}, best {:.6f}, period of lambda {:.3e}", j + 1, phase.hole_winding[j],
                         phase.best_hole_winding[j], phase.hole_periods[j]));
  if (num_holes > most_holes) run.info(fmt::format("{} more holes: see --report", num_holes - most_holes));
  if (num_holes > 0)
    run.info(fmt::format("energy of integer winding above real winding: {:.3e}", phase.hole_winding_energy));
}

/// Of the fields of all regions; the strength of the options does not count.
void report_alignment(const std::vector<SolvedRegion>& regions, const AlignmentRequest& request, double diameter,
                      Run& run) {
  const Alignment alignment = field::make_alignment(request, 1, diameter);
  field::Misalignment sum;
  for (const SolvedRegion& region : regions) sum += field::misalignment(field::FieldEvaluator(region.field), alignment);
  run.report().set("align.rms_degrees", sum.rms_degrees());
  run.report().set("align.mean_cosine_loss", sum.mean_cosine_loss());
  run.info(
      fmt::format("crosses are {:.1f} degrees from the prescribed directions (root mean square)", sum.rms_degrees()));
}

std::size_t num_liftings(const Field& field) {
  std::size_t count = field.liftings.size() + field.phase.terms.corner_angles.size();
  for (const PhaseForm& phase : field.region_phases) count += phase.terms.corner_angles.size();
  return count;
}

}  // namespace

void FieldsolveOptions::validate() const {
  const int max_order = galerkin::max_field_order(solve.method);
  if (!nodes_file.empty() && (solve.method != FieldMethod::cg || solve.corners != galerkin::CornerData::lift))
    throw UsageError("--nodes needs --method cg and --corners lift");
  if (!align_file.empty() && solve.method != FieldMethod::cg) throw UsageError("--align needs --method cg");
  if (order > max_order) throw UsageError(fmt::format("--field-order is at most {} with --method dg", max_order));
}

void declare(Options& o, FieldsolveOptions& fieldsolve) {
  o.integer("--field-order", fieldsolve.order, 1, 20,
            "polynomial order of the field on every element (dg: at most 12)");
  o.input_file("--orders", fieldsolve.orders_file, "FILE",
               "the order of each element, from an order map (JSON) or a field; replaces --field-order; with --nodes, "
               "orders of a harmonic field are lowered where the phase needs less",
               false);
  o.input_file(
      "--nodes", fieldsolve.nodes_file, "CRIT",
      "critical points (x.crit.json) that prescribe the irregular nodes and corner valences of the field; cg only",
      false);
  o.input_file(
      "--align", fieldsolve.align_file, "FILE",
      "directions that the crosses follow inside the domain: at points, along curves, in boxes (JSON), or those "
      "of a metric (CSV) (formats/alignment.md); cg only",
      false);
  o.number("--align-strength", fieldsolve.align_strength, 0, 1000, "1",
           "weight of these, over that of each feature of the file: there crosses turn to its direction over the "
           "distance width / strength");
  o.choice("--method", fieldsolve.solve.method, "continuous or discontinuous (hybridised) elements");
  o.choice("--corners", fieldsolve.solve.corners, "tangent discontinuities: lifted exactly, or left in the data");
}

Field fieldsolve(const FieldsolveInput& input, const FieldsolveOptions& options, Run& run) {
  require_intervals(options);
  options.validate();
  const TriMesh& mesh = input.mesh.model;
  check::require_sound(mesh, input.mesh.file.name);
  if (input.nodes) require_nodes_of(*input.nodes, input.mesh);
  std::vector<InputDigest> inputs{input.mesh.file.digest("tri-mesh")};
  if (input.orders) inputs.push_back(input.orders->file.digest(input.orders_format));
  if (input.nodes) inputs.push_back(input.nodes->file.digest("critical-points"));
  if (input.alignment) inputs.push_back(input.alignment->file.digest("alignment"));
  const OrderMap orders =
      input.orders ? input.orders->model : OrderMap{std::vector<int>(mesh.num_elems(), options.order)};
  run.begin_phase("solve");
  galerkin::LaplaceOptions solving = options.solve;
  solving.num_threads = run.threads();
  AlignmentRequest aligned;
  if (input.alignment) {
    aligned = alignment_on_face(input.alignment->model, mesh.face, "--align");
    solving.alignment = field::make_alignment(aligned, options.align_strength, mesh.face.diameter);
  }
  const std::vector<TriMesh> meshes = regions::split(mesh);
  std::vector<SolvedRegion> regions = solved(mesh, meshes, orders, input.nodes, solving, run.report());
  if (input.nodes)
    for (const SolvedRegion& region : regions) report_phase(region.field.phase, run);
  if (input.alignment) report_alignment(regions, aligned, mesh.face.diameter, run);
  run.begin_phase("estimate");
  std::vector<Field> parts;
  for (SolvedRegion& region : regions) {
    if (options.estimates_errors)
      region.field.elem_error = field::error_estimate(region.field, region.phase ? region.phase->boundary() : nullptr);
    parts.push_back(std::move(region.field));
  }
  run.end_phase();
  Field field = regions::join(mesh, std::move(parts));
  const auto [lowest, highest] = std::minmax_element(field.elem_order.begin(), field.elem_order.end());
  run.report().set("solve.field_order", *highest);
  if (options.estimates_errors)
    run.report().set("solve.max_error", *std::max_element(field.elem_error.begin(), field.elem_error.end()));
  field.provenance = with_step(mesh.provenance, "fieldsolve", options, std::move(inputs));
  run.info(fmt::format("{} of order {}..{}, {}", counted(mesh.num_elems(), "element"), *lowest, *highest,
                       counted(num_liftings(field), "lifting")));
  return field;
}

}  // namespace quadrille::stage
