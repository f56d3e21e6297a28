// fieldsolve: solves for the guiding field on a triangle mesh, both Laplace problems at once.

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "base/counted.hpp"
#include "base/error.hpp"
#include "check/check.hpp"
#include "cli/tool_main.hpp"
#include "field/error_estimate.hpp"
#include "galerkin/phase_orders.hpp"
#include "galerkin/phase_request.hpp"
#include "galerkin/solve_laplace.hpp"
#include "galerkin/solve_phase.hpp"
#include "io/input_file.hpp"
#include "io/order_map.hpp"
#include "io/output_file.hpp"
#include "io/stage_files.hpp"
#include "regions/join.hpp"
#include "regions/region_numbers.hpp"
#include "regions/region_work.hpp"
#include "regions/split.hpp"

using namespace quadrille;

namespace {

// Reads the irregular nodes and checks that a field on this mesh can have them. They may be from a field on another
// mesh, or have been moved: then the element numbers in the file are meaningless.
CriticalPoints read_nodes(const io::InputFile& file, const io::InputFile& mesh_file, TriMesh& mesh) {
  CriticalPoints points = io::read_critical_points(file);
  check::require_valid(check::check_critical_points(points, check::CheckDepth::quick), file.name);
  Field of_face;
  std::swap(of_face.mesh, mesh);
  std::vector<check::Violation> violations = check::check_critical_points_of(points, of_face);
  std::swap(of_face.mesh, mesh);
  std::erase_if(violations, [](const check::Violation& violation) { return violation.rule == "CRT-R09"; });
  if (!violations.empty()) io::require_same_origin(mesh_file, mesh.provenance, file, points.provenance);
  check::require_valid(violations, file.name);
  if (points.origin != mesh.face.origin)
    throw FormatError(
        fmt::format("{}: its origin differs from that of the mesh: it belongs to another face", file.name));
  return points;
}

/// The field of one region. Of the phase form, the boundary data of its solver serve the error estimate too.
struct SolvedRegion {
  Field field;
  std::unique_ptr<galerkin::PhaseSolver> phase;
};

/// The nodes that the fields must have, and the file that prescribes them.
struct PrescribedNodes {
  CriticalPoints points;
  std::string file;
};

// `meshes`: of the regions; they must outlive the result.
std::vector<SolvedRegion> solved(const TriMesh& mesh, const std::vector<TriMesh>& meshes, const io::OrderMap& orders,
                                 const std::optional<PrescribedNodes>& prescribed,
                                 const galerkin::LaplaceOptions& options, Report& report) {
  const std::vector<CriticalPoints> nodes =
      prescribed ? regions::split(prescribed->points, mesh) : std::vector<CriticalPoints>(meshes.size());
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
            orders.of_harmonic_field ? galerkin::phase_orders(meshes[region], part_orders) : part_orders, threads);
        galerkin::require_possible(*result.phase, meshes[region].face, phase_nodes, prescribed->file);
        result.field = result.phase->solve(phase_nodes, {nodes[region].hole_winding_offsets}, part_report);
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

void report_phase(const PhaseForm& phase, cli::Session& s) {
  constexpr std::size_t most_holes = 20;
  std::vector<int> nodes, corners;
  for (const PhaseNode& node : phase.prescribed.nodes) nodes.push_back(node.valence);
  for (const CornerValence& corner : phase.prescribed.corners) corners.push_back(corner.valence);
  s.info(fmt::format("nodes: {}; corners: {}", nodes.empty() ? "none" : counts_by_valence(nodes),
                     corners.empty() ? "none" : counts_by_valence(corners)));
  const std::size_t num_holes = phase.hole_winding.size();
  for (std::size_t j = 0; j < std::min(num_holes, most_holes); ++j)
    s.info(fmt::format("hole {}: winding {}, best {:.6f}, period of lambda {:.3e}", j + 1, phase.hole_winding[j],
                       phase.best_hole_winding[j], phase.hole_periods[j]));
  if (num_holes > most_holes) s.info(fmt::format("{} more holes: see --report", num_holes - most_holes));
  if (num_holes > 0)
    s.info(fmt::format("energy of integer winding above real winding: {:.3e}", phase.hole_winding_energy));
}

std::size_t num_liftings(const Field& field) {
  std::size_t count = field.liftings.size() + field.phase.terms.corner_angles.size();
  for (const PhaseForm& phase : field.region_phases) count += phase.terms.corner_angles.size();
  return count;
}

}  // namespace

int main(int argc, char** argv) {
  std::string input = "-", output = "-", orders_path, nodes_path;
  galerkin::LaplaceOptions options;
  int order = 8;

  cli::Tool tool;
  tool.name = "fieldsolve";
  tool.summary = "solves for the guiding field on a triangle mesh";
  tool.description =
      "Reads the triangle mesh TRI and writes the guiding field v = (u, v): harmonic inside, the cross (cos 4 theta, "
      "sin 4 theta) of the tangent angle theta on the boundary. The elements of the Galerkin method are continuous "
      "(cg) or discontinuous (dg, hybridised); interior modes are condensed, and one sparse factorisation serves both "
      "components. Boundary data come from the exact curves; every tangent discontinuity is represented by an exact "
      "harmonic function, so that corners do not reduce the accuracy. --corners dg leaves the discontinuities in the "
      "data, as the paper does, for comparison; only --method dg can represent them. With --nodes the field is a unit "
      "field with exactly the irregular nodes and corner valences of CRIT (the phase form, x.phase.h5), as critpoints "
      "or an editor prescribed them.";
  tool.examples = {"fieldsolve half_disc.tri.h5 -o half_disc.solve.h5",
                   "fieldsolve --field-order 12 half_disc.tri.h5 -o half_disc.solve.h5",
                   "fieldsolve --method dg half_disc.tri.h5 -o half_disc.solve.h5",
                   "fieldsolve --orders half_disc.field.h5 half_disc.tri.h5 -o half_disc.solve.h5",
                   "fieldsolve --nodes half_disc.crit.json half_disc.tri.h5 -o half_disc.phase.h5",
                   "cad2tri half_disc.step | fieldsolve | padapt -o half_disc.field.h5"};
  tool.options = [&](cli::Options& o) {
    o.input("TRI", input, "triangle mesh (x.tri.h5)");
    o.output(output, "field to write (x.solve.h5)");
    o.integer("--field-order", order, 1, 20, "polynomial order of the field on every element (dg: at most 12)");
    o.input_file(
        "--orders", orders_path, "FILE",
        "the order of each element, from an order map (JSON) or a field; replaces --field-order; with --nodes, "
        "orders of a harmonic field are lowered where the phase needs less",
        false);
    o.input_file(
        "--nodes", nodes_path, "CRIT",
        "critical points (x.crit.json) that prescribe the irregular nodes and corner valences of the field; cg only",
        false);
    o.choice("--method", options.method, "continuous or discontinuous (hybridised) elements");
    o.choice("--corners", options.corners, "tangent discontinuities: lifted exactly, or left in the data");
  };
  tool.run = [&](cli::Session& s) {
    options.num_threads = s.threads();
    const int max_order = galerkin::max_field_order(options.method);
    if (!nodes_path.empty() && (options.method != FieldMethod::cg || options.corners != galerkin::CornerData::lift))
      throw UsageError("--nodes needs --method cg and --corners lift");
    if (order > max_order) throw UsageError(fmt::format("--field-order is at most {} with --method dg", max_order));
    const io::InputFile file = io::read_input(input);
    TriMesh mesh = io::read_tri_mesh(file);
    check::require_valid(check::check_tri_mesh(mesh, check::CheckDepth::quick), file.name);
    std::vector<InputDigest> inputs{file.digest("tri-mesh")};
    io::OrderMap orders{std::vector<int>(mesh.num_elems(), order)};
    if (!orders_path.empty()) {
      const io::InputFile orders_file = io::read_input(orders_path);
      orders = io::read_order_map(orders_file, mesh.num_elems(), max_order);
      inputs.push_back(orders_file.digest(io::order_map_format(orders_file)));
    }
    std::optional<PrescribedNodes> prescribed;
    if (!nodes_path.empty()) {
      const io::InputFile nodes_file = io::read_input(nodes_path);
      prescribed = {read_nodes(nodes_file, file, mesh), nodes_file.name};
      inputs.push_back(nodes_file.digest("critical-points"));
    }
    s.begin_phase("solve");
    const std::vector<TriMesh> meshes = regions::split(mesh);
    std::vector<SolvedRegion> regions = solved(mesh, meshes, orders, prescribed, options, s.report());
    if (prescribed)
      for (const SolvedRegion& region : regions) report_phase(region.field.phase, s);
    s.begin_phase("estimate");
    std::vector<Field> parts;
    for (SolvedRegion& region : regions) {
      region.field.elem_error = field::error_estimate(region.field, region.phase ? region.phase->boundary() : nullptr);
      parts.push_back(std::move(region.field));
    }
    s.end_phase();
    Field field = regions::join(mesh, std::move(parts));
    const auto [lowest, highest] = std::minmax_element(field.elem_order.begin(), field.elem_order.end());
    s.report().set("solve.field_order", *highest);
    s.report().set("solve.max_error", *std::max_element(field.elem_error.begin(), field.elem_error.end()));
    field.provenance = s.provenance(mesh.provenance, inputs);
    s.info(fmt::format("{} of order {}..{}, {}", counted(mesh.num_elems(), "element"), *lowest, *highest,
                       counted(num_liftings(field), "lifting")));
    io::write_field(output, field);
  };
  tool.report_writer = io::write_report;
  return cli::tool_main(argc, argv, tool);
}
