#include "stage/solver_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <optional>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/parallel.hpp"
#include "base/warning_codes.hpp"
#include "export/as_read.hpp"
#include "export/plate_mesh.hpp"
#include "export/poly_faces.hpp"
#include "spectral/det_sampler.hpp"
#include "spectral/quad_map.hpp"
#include "surface/positions.hpp"

namespace quadrille::stage {

namespace {

// What differs between quads and hexahedra. Positions of quads are (x, y, 0), relative to the face's origin.

ElementKind kind_of(const QuadMesh& /*mesh*/) { return ElementKind::quads; }
ElementKind kind_of(const HexMesh& /*mesh*/) { return ElementKind::hexahedra; }
int dimension_of(const QuadMesh& /*mesh*/) { return 2; }
int dimension_of(const HexMesh& /*mesh*/) { return 3; }

mesh::StraightCells cells_of(const QuadMesh& mesh, const std::vector<exports::PatchType>& types) {
  return exports::straight_cells(mesh, types);
}
mesh::StraightCells cells_of(const HexMesh& mesh, const std::vector<exports::PatchType>& types) {
  return exports::straight_cells(mesh, exports::poly_faces(mesh, types));
}

std::vector<double> position_in_file(const QuadMesh& mesh, Vec3 x) {
  return surface::position_in_file(mesh.face, Vec2{x.x, x.y});
}
std::vector<double> position_in_file(const HexMesh& /*mesh*/, Vec3 x) { return {x.x, x.y, x.z}; }

std::string place_text(const QuadMesh& mesh, Vec3 x) { return surface::position_text(mesh.face, Vec2{x.x, x.y}); }
std::string place_text(const HexMesh& /*mesh*/, Vec3 x) { return position_text(x); }

template <typename Point>
std::vector<Point> own_nodes(const std::vector<Point>& nodes, const std::vector<int>& elem_nodes, int count, int elem) {
  std::vector<Point> own;
  for (int k = 0; k < count; ++k) own.push_back(nodes[elem_nodes[static_cast<std::size_t>(elem) * count + k]]);
  return own;
}

/// The nodes of an element; in space those of a quad as seen along its normal in the middle.
std::vector<Vec2> nodes_of(const QuadMesh& mesh, int elem) {
  const int count = mesh.nodes_per_elem();
  if (mesh.space_nodes.empty()) return own_nodes(mesh.nodes, mesh.elem_nodes, count, elem);
  const std::vector<Vec3> in_space = own_nodes(mesh.space_nodes, mesh.elem_nodes, count, elem);
  return spectral::quad_projection(mesh.order, in_space.data());
}
std::vector<Vec3> nodes_of(const HexMesh& mesh, int elem) {
  return own_nodes(mesh.nodes, mesh.elem_nodes, mesh.nodes_per_elem(), elem);
}

/// In the chart, as positions of other measures.
Vec3 middle_of(const QuadMesh& mesh, int elem) {
  const std::vector<Vec2> nodes = own_nodes(mesh.nodes, mesh.elem_nodes, mesh.nodes_per_elem(), elem);
  const Vec2 middle = spectral::quad_position(mesh.order, nodes.data(), {0, 0});
  return {middle.x, middle.y, 0};
}
Vec3 middle_of(const HexMesh& mesh, int elem) {
  const std::vector<Vec3> nodes = nodes_of(mesh, elem);
  Vec3 middle;
  for (int c = 0; c < 8; ++c) middle += 0.125 * nodes[exports::hex_corner_node(mesh.order, c)];
  return middle;
}

std::vector<double> dets_at(const spectral::DetSampler& sampler, const Vec2* nodes) { return sampler.of_quad(nodes); }
std::vector<double> dets_at(const spectral::DetSampler& sampler, const Vec3* nodes) { return sampler.of_hex(nodes); }

/// The longest diagonal.
double diameter_of(const QuadMesh& mesh, const std::vector<Vec2>& nodes) {
  const auto corner = [&](int side) { return nodes[local_side_node(mesh.order, side, 0)]; };
  return std::max(distance(corner(0), corner(2)), distance(corner(1), corner(3)));
}
double diameter_of(const HexMesh& mesh, const std::vector<Vec3>& nodes) {
  double longest = 0;
  for (const int lower : {0, 1, 2, 3}) {
    const int upper = 4 + (lower + 2) % 4;
    longest = std::max(longest, norm(nodes[exports::hex_corner_node(mesh.order, upper)] -
                                     nodes[exports::hex_corner_node(mesh.order, lower)]));
  }
  return longest;
}

/// Of det J at the points of the program; in the unit of the file.
template <typename Mesh>
double value_of(const Mesh& mesh, const spectral::DetSampler& sampler, int elem, SolverMeasure measure, double scale) {
  const auto nodes = nodes_of(mesh, elem);
  const int dimension = dimension_of(mesh);
  const std::vector<double> dets = dets_at(sampler, nodes.data());
  const auto [least, greatest] = std::ranges::minmax(dets);
  if (measure == SolverMeasure::jacobian_ratio) return greatest > 0 ? least / greatest : -1;
  if (measure == SolverMeasure::relative_jacobian) return std::pow(2 / diameter_of(mesh, nodes), dimension) * least;
  return std::pow(scale, dimension) * least;
}

template <typename Mesh>
std::vector<mesh::CellSample> jacobian_samples(const Mesh& mesh, const SolverRequest& request, SolverMeasure measure,
                                               int num_threads) {
  const spectral::DetSampler sampler(mesh.order, request.solver.points(mesh.order));
  std::vector<mesh::CellSample> samples(mesh.num_elems());
  parallel_for(mesh.num_elems(), num_threads, [&](int elem) {
    samples[elem] = {value_of(mesh, sampler, elem, measure, request.scale), elem, middle_of(mesh, elem)};
  });
  return samples;
}

/// The name in keys of the report: "jacobian_ratio".
std::string key_of(const SolverMeasureRow& row) {
  std::string key(row.name);
  for (char& c : key) c = c == ' ' || c == '-' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return key;
}

/// The greater the worse.
double badness(const SolverMeasureRow& row, double value) { return row.is_least_worst ? -value : value; }

bool reaches(const SolverMeasureRow& row, double value, const std::optional<double>& limit) {
  return limit && badness(row, value) >= badness(row, *limit);
}

/// "skewness 5.3 of element 12 near (1, 2) reaches the limit 4 of OpenFOAM (3 places do): refine there"
template <typename Mesh>
std::string limit_text(const SolverMeasureRow& row, const SolverRow& solver, const Mesh& mesh,
                       const mesh::CellSample& worst, int element, double limit, std::ptrdiff_t count) {
  return fmt::format("{} {:.4g}{} of element {} near {} reaches the limit {:.4g} of {}{}: {}", row.name, worst.value,
                     row.unit, element, place_text(mesh, worst.position), limit, solver.title,
                     count > 1 ? fmt::format(" ({} places do)", count) : "", row.remedy);
}

template <typename Mesh>
class SolverChecker {
 public:
  SolverChecker(const Mesh& mesh, const SolverRequest& request, Run& run)
      : mesh_(mesh), read_(exports::as_read(mesh, request.format)), request_(request), run_(run) {}

  void check() {
    run_.report().set("check_for.solver", std::string(request_.solver.name));
    run_.report().set("check_for.elements", read_.num_elems());
    if (request_.solver.points == nullptr) {
      cells_ = cells_of(read_, request_.patch_types);
      // Files without types of boundaries do not say that faces are periodic.
      if (request_.format.write_with_types == nullptr) cells_.coupled.clear();
      geometry_ = mesh::cell_geometry(cells_, request_.solver.centre);
    }
    for (const SolverLimit& limit : request_.solver.limits) check_limit(limit);
    if (!failures_.empty()) throw ComputeError(failures_ + "; without --check-for the mesh is written all the same");
  }

 private:
  void check_limit(const SolverLimit& limit) {
    const SolverMeasureRow& row = solver_measure(limit.measure);
    const std::vector<mesh::CellSample> samples = row.of_cells != nullptr
                                                      ? row.of_cells(cells_, geometry_)
                                                      : jacobian_samples(read_, request_, row.measure, run_.threads());
    if (samples.empty()) return;
    const mesh::CellSample worst = *std::max_element(samples.begin(), samples.end(), [&](const auto& a, const auto& b) {
      return badness(row, a.value) < badness(row, b.value);
    });
    const int element = exports::source_element(mesh_, read_, worst.cell);
    report_worst(row, worst, element);
    const bool is_failure = reaches(row, worst.value, limit.failure);
    if (!is_failure && !reaches(row, worst.value, limit.warning)) return;
    const double reached = is_failure ? *limit.failure : *limit.warning;
    const auto count = std::count_if(samples.begin(), samples.end(), [&](const mesh::CellSample& sample) {
      return reaches(row, sample.value, reached);
    });
    const std::string text = limit_text(row, request_.solver, mesh_, worst, element, reached, count);
    if (is_failure)
      failures_ += (failures_.empty() ? "" : "; ") + text;
    else
      run_.report().warn(warning::limit_of_solver, text);
  }

  void report_worst(const SolverMeasureRow& row, const mesh::CellSample& worst, int element) {
    const std::string name = key_of(row);
    Report& report = run_.report();
    report.set(fmt::format("check_for.{}.value", name), worst.value);
    report.set(fmt::format("check_for.{}.element", name), element);
    report.set(fmt::format("check_for.{}.position", name), position_in_file(mesh_, worst.position));
    run_.info(fmt::format("{}: {} {:.4g}{} at worst, of element {} near {}", request_.solver.title, row.name,
                          worst.value, row.unit, element, place_text(mesh_, worst.position)));
  }

  const Mesh& mesh_;
  const Mesh read_;
  const SolverRequest& request_;
  Run& run_;
  mesh::StraightCells cells_;
  mesh::CellGeometry geometry_;
  std::string failures_;
};

template <typename Mesh>
void check_mesh(const Mesh& mesh, const SolverRequest& request, Run& run) {
  if (const std::string refusal = order_refusal(request.solver, kind_of(mesh), mesh.order); !refusal.empty())
    throw ComputeError(refusal);
  SolverChecker<Mesh>(mesh, request, run).check();
}

}  // namespace

void require_format_of_solver(const SolverRow& solver, const std::string& format) {
  if (std::find(solver.formats.begin(), solver.formats.end(), format) == solver.formats.end())
    throw UsageError(fmt::format("--check-for {}: {} does not read the format {}: choose {}", solver.name, solver.title,
                                 format, fmt::join(solver.formats, ", ")));
}

std::string order_refusal(const SolverRow& solver, ElementKind kind, int order) {
  const int greatest = kind == ElementKind::quads ? solver.max_order : solver.max_hex_order;
  if (order <= greatest) return {};
  if (greatest == 0)
    return fmt::format("--check-for {}: {} computes on volumes: make hexahedra of the quads (hexsweep)", solver.name,
                       solver.title);
  return fmt::format("--check-for {}: {} reads {} up to order {}, these have order {}: refine with a lower --order",
                     solver.name, solver.title, kind == ElementKind::quads ? "quads" : "hexahedra", greatest, order);
}

void check_for_solver(const QuadMesh& mesh, const SolverRequest& request, Run& run) { check_mesh(mesh, request, run); }
void check_for_solver(const HexMesh& mesh, const SolverRequest& request, Run& run) { check_mesh(mesh, request, run); }

}  // namespace quadrille::stage
