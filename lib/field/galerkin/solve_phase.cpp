#include "galerkin/solve_phase.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "field/explicit_value.hpp"
#include "galerkin/aligned_field.hpp"
#include "galerkin/discretization.hpp"
#include "galerkin/hole_winding.hpp"
#include "galerkin/phase_energy.hpp"
#include "mesh/locate.hpp"

namespace quadrille::galerkin {
namespace {

/// Functions that are solved for together: wide matrices are faster, but take memory.
constexpr std::size_t batch = 8;

/// Dofs and what the coefficients may be without them: less than any that count.
constexpr double negligible_dof = 1.0 / 16;

/// Adds what a part is on an element, by the two columns of its coefficients there.
void add_element(int elem, const Eigen::Ref<const Eigen::MatrixXd>& coefs, double negligible,
                 field::HarmonicPart& part) {
  auto modes = coefs.rows();
  while (modes > 0 && coefs.row(modes - 1).cwiseAbs().maxCoeff() < negligible) --modes;
  if (modes == 0) return;
  part.elems.push_back(elem);
  part.num_modes.push_back(static_cast<int>(modes));
  const auto u = coefs.col(0).head(modes), v = coefs.col(1).head(modes);
  part.u.insert(part.u.end(), u.begin(), u.end());
  part.v.insert(part.v.end(), v.begin(), v.end());
}

double greatest_of_element(const DofMap& map, int elem, const Eigen::VectorXd& dofs) {
  double greatest = 0;
  for (int i = map.elem2offset[elem]; i < map.elem2offset[elem + 1]; ++i)
    if (map.elem2dofs[i] >= 0) greatest = std::max(greatest, dofs[map.elem2dofs[i]]);
  return greatest;
}

/// The parts of hundreds of functions are most of the memory.
void shrink(field::HarmonicPart& part) {
  for (std::vector<double>* values : {&part.u, &part.v}) values->shrink_to_fit();
  for (std::vector<int>* values : {&part.elems, &part.num_modes}) values->shrink_to_fit();
}

/// The harmonic measures w_j of the holes: 1 on hole j, 0 on the other loops.
struct HoleMeasures {
  SparseColumns given;  ///< their boundary dofs, one column per hole
  Eigen::MatrixXd k;    ///< K_ij = a(w_i, w_j)
  Eigen::LDLT<Eigen::MatrixXd> factored_k;
  Eigen::VectorXd m;  ///< the hole winding found last
};

}  // namespace

/// The boundary data of one set of nodes, and their projections for the orders of the last solution.
struct PhaseSolver::Given {
  Given(const TriMesh& mesh, std::shared_ptr<BoundaryPoints> points, const PhaseNodes& nodes,
        std::shared_ptr<field::SharedCorners> corners)
      : asked(nodes),
        boundary(mesh, asked, std::move(corners)),
        data(std::move(points),
             [this](int curve, std::span<const double> t, double* values) { boundary.remainders(curve, t, values); }) {}

  PhaseNodes asked;
  field::PhaseBoundary boundary;
  DirichletData data;
};

struct PhaseSolver::KnownEnergy {
  PhaseNodes asked;
  std::vector<int> hole_winding_offsets;
  PhaseEnergy energy;
};

/// Data computed once: for the mesh, then for the order map, then for the nodes.
struct PhaseSolver::Parts {
  Parts(const TriMesh& mesh, int threads, Alignment prescribed)
      : context(mesh),
        num_threads(threads),
        system(context, threads),
        points(std::make_shared<BoundaryPoints>(mesh)),
        alignment(std::move(prescribed)),
        term(alignment) {}

  MeshContext context;
  int num_threads;
  ContinuousSystem system;
  std::shared_ptr<BoundaryPoints> points;
  std::unique_ptr<mesh::Locator> locator;  ///< constructed by the first call of energy()

  Alignment alignment;
  field::AlignmentTerm term;
  std::unique_ptr<ContinuousSystem> aligned;  ///< with the term; made by the first use

  std::vector<int> elem_order;
  bool is_factored = false, is_aligned_factored = false, has_measures = false;
  HoleMeasures holes;
  std::shared_ptr<field::SharedCorners> corners;  ///< of the valences of the last nodes
  std::unique_ptr<Given> given;
  std::optional<KnownEnergy> known_energy;  ///< the last, for this order map
  Stopwatch watch;
};

/// The solution for one set of nodes.
struct PhaseSolver::State {
  PhaseForm form;                  ///< without s
  Eigen::VectorXd dofs;            ///< of s, including the hole winding
  double remainder_energy = 0;     ///< a(s, s) / 2
  Eigen::VectorXd hole_reactions;  ///< a(s, w_j)
  Eigen::VectorXd best_winding;    ///< m* of lib/method.md §8.6
};

PhaseSolver::PhaseSolver(const TriMesh& mesh, std::vector<int> elem_order, int num_threads, Alignment alignment)
    : parts_(std::make_unique<Parts>(mesh, num_threads, std::move(alignment))) {
  set_orders(std::move(elem_order));
}
PhaseSolver::~PhaseSolver() = default;
PhaseSolver::PhaseSolver(PhaseSolver&&) noexcept = default;

void PhaseSolver::set_orders(std::vector<int> elem_order) {
  if (elem_order.size() != parts_->context.maps.size()) throw Defect("the order map does not fit the mesh");
  if (elem_order == parts_->elem_order) return;
  parts_->elem_order = std::move(elem_order);
  parts_->is_factored = parts_->is_aligned_factored = parts_->has_measures = false;
  parts_->known_energy.reset();
}

int PhaseSolver::num_unknowns(const std::vector<int>& elem_order) const {
  return parts_->system.num_unknowns(elem_order);
}

void PhaseSolver::factor() {
  if (parts_->is_factored) return;
  parts_->system.set_orders(parts_->elem_order, parts_->watch);
  parts_->is_factored = true;
}

ContinuousSystem& PhaseSolver::aligned_system() {
  if (!parts_->aligned)
    parts_->aligned = std::make_unique<ContinuousSystem>(parts_->context, parts_->num_threads,
                                                         ContinuousSystem::default_kept_numbers, &parts_->term);
  if (!parts_->is_aligned_factored) parts_->aligned->set_orders(parts_->elem_order, parts_->watch);
  parts_->is_aligned_factored = true;
  return *parts_->aligned;
}

std::vector<field::HarmonicPart> PhaseSolver::harmonic_parts(const std::vector<field::LiftedData>& data,
                                                             double negligible) {
  const bool is_aligned = !parts_->alignment.empty();
  if (!is_aligned) factor();
  ContinuousSystem& system = is_aligned ? aligned_system() : parts_->system;
  std::vector<field::HarmonicPart> parts(data.size());
  for (std::size_t first = 0; first < data.size(); first += batch) {
    const std::size_t last = std::min(first + batch, data.size());
    Eigen::MatrixXd given(system.map().num_dofs - system.map().num_unknowns, 2 * (last - first));
    for (std::size_t i = first; i < last; ++i) {
      parts[i].liftings = data[i].liftings;
      given.middleCols(2 * (i - first), 2) =
          DirichletData(parts_->points, data[i].values).values(parts_->context.topology, system.map());
    }
    std::vector<const std::vector<Lifting>*> liftings;
    for (std::size_t k = first; k < last; ++k) liftings.push_back(&data[k].liftings);
    const Loads loads = is_aligned ? system.loads(right_side_beside(parts_->term, liftings, false)) : Loads();
    const Eigen::MatrixXd dofs =
        system.solve(given, parts_->watch, is_aligned ? 0 : negligible_dof * negligible, loads);
    const Eigen::VectorXd sizes = dofs.rowwise().lpNorm<Eigen::Infinity>();
    for (int e = 0; e < std::ssize(parts_->elem_order); ++e) {
      if (greatest_of_element(system.map(), e, sizes) < negligible_dof * negligible) continue;
      const Eigen::MatrixXd coefs = system.coefs(e, dofs, loads);
      for (std::size_t i = first; i < last; ++i)
        add_element(e, coefs.middleCols(2 * (i - first), 2), negligible, parts[i]);
    }
    for (std::size_t i = first; i < last; ++i) shrink(parts[i]);
  }
  return parts;
}

// On hole j the vertex modes of w_j are 1, and its edge modes vanish.
void PhaseSolver::measure_holes() {
  factor();
  if (parts_->has_measures) return;
  parts_->has_measures = true;
  const TriMesh& mesh = *parts_->context.mesh;
  const DofMap& map = parts_->system.map();
  const int num_holes = mesh.face.num_loops() - 1;
  std::vector<Eigen::Triplet<double>> entries;
  for (const BoundaryEdge& edge : mesh.boundary_edges) {
    const int loop = mesh.face.loop_of(edge.curve);
    const int begin = mesh.elem2vertices[edge.elem][edge.edge];  // each vertex of a loop begins one edge
    if (loop > 0) entries.emplace_back(map.vertex2dof[begin] - map.num_unknowns, loop - 1, 1.0);
  }
  HoleMeasures& holes = parts_->holes;
  holes.given.resize(map.num_dofs - map.num_unknowns, num_holes);
  holes.given.setFromTriplets(entries.begin(), entries.end());
  holes.k = parts_->system.energy_products(holes.given);
  holes.factored_k.compute(holes.k);
  if (holes.m.size() == 0) holes.m = Eigen::VectorXd::Zero(num_holes);
}

void PhaseSolver::set_nodes(const PhaseNodes& asked) {
  if (parts_->given && parts_->given->asked == asked) return;
  const TriMesh& mesh = *parts_->context.mesh;
  if (!parts_->corners || !parts_->corners->fit(asked))
    parts_->corners = std::make_shared<field::SharedCorners>(mesh.face, asked);
  parts_->given = std::make_unique<Given>(mesh, parts_->points, asked, parts_->corners);
}

const field::PhaseBoundary* PhaseSolver::boundary() const { return parts_->given ? &parts_->given->boundary : nullptr; }

PhaseSolver::State PhaseSolver::state(const PhaseNodes& asked, const std::vector<int>& winding_offsets) {
  const TriMesh& mesh = *parts_->context.mesh;
  const std::size_t num_holes = mesh.face.num_loops() - 1;
  if (!winding_offsets.empty() && winding_offsets.size() != num_holes)
    throw UsageError(
        fmt::format("hole_winding_offsets has {} entries for {} holes", winding_offsets.size(), num_holes));
  set_nodes(asked);
  const field::PhaseBoundary& boundary = parts_->given->boundary;
  measure_holes();
  const Eigen::MatrixXd data = parts_->given->data.values(parts_->context.topology, parts_->system.map());

  State state;
  PhaseForm& form = state.form;
  form.prescribed = asked;
  form.terms = boundary.terms();
  form.hole_winding_offsets = winding_offsets;
  // The winding of the last nodes is mostly that of these nodes too.
  solve_for_winding(data, state);
  if (num_holes == 0) return state;
  Eigen::VectorXd& m = parts_->holes.m;
  const Eigen::VectorXd nearest = nearest_winding(state);
  if (nearest != m) {
    m = nearest;
    solve_for_winding(data, state);
  }
  form.hole_winding.assign(m.begin(), m.end());
  const Eigen::VectorXd above = m - state.best_winding;
  form.best_hole_winding.assign(state.best_winding.begin(), state.best_winding.end());
  const Eigen::VectorXd periods = state.hole_reactions / 4;
  form.hole_periods.assign(periods.begin(), periods.end());
  form.hole_winding_energy = pi * above.dot(state.hole_reactions);
  return state;
}

// lib/method.md §8.6: with the reactions R = r + 2 pi K m of the holes the best real winding is m - K^-1 R / (2 pi).
void PhaseSolver::solve_for_winding(const Eigen::MatrixXd& data, State& state) {
  const HoleMeasures& holes = parts_->holes;
  const Eigen::MatrixXd given = holes.m.size() == 0 ? data : data + 2 * pi * (holes.given * holes.m);
  state.dofs = parts_->system.solve(given, parts_->watch);
  if (!state.dofs.allFinite()) throw ComputeError("the solution is not finite: some element has a folded shape");
  const Eigen::VectorXd reaction = parts_->system.reactions(state.dofs);
  state.remainder_energy = given.col(0).dot(reaction) / 2;
  if (holes.m.size() == 0) return;
  state.hole_reactions = holes.given.transpose() * reaction;
  state.best_winding = holes.m - holes.factored_k.solve(state.hole_reactions) / (2 * pi);
  if (!state.best_winding.allFinite())
    throw ComputeError("the winding of the holes is not finite: some element has a folded shape");
}

Eigen::VectorXd PhaseSolver::nearest_winding(const State& state) const {
  const std::vector<int> nearest = nearest_hole_winding(parts_->holes.k, state.best_winding);
  Eigen::VectorXd m = Eigen::Map<const Eigen::VectorXi>(nearest.data(), std::ssize(nearest)).cast<double>();
  for (std::size_t j = 0; j < state.form.hole_winding_offsets.size(); ++j) m[j] += state.form.hole_winding_offsets[j];
  return m;
}

Field PhaseSolver::solve(const PhaseNodes& asked, const std::vector<int>& winding_offsets, Report& report) {
  parts_->watch = Stopwatch();
  parts_->context.progress = report.progress();
  State state = this->state(asked, winding_offsets);
  const TriMesh& mesh = *parts_->context.mesh;
  Field field;
  field.provenance = mesh.provenance;
  field.mesh = mesh;
  field.kind = FieldKind::phase;
  field.elem_order = parts_->elem_order;
  field.phase = std::move(state.form);
  field.coef_offsets.push_back(0);
  std::vector<Eigen::MatrixXd> all_coefs = parts_->system.all_coefs(state.dofs);
  if (!parts_->alignment.empty())
    align_phase(parts_->context, aligned_system(), parts_->term, field.phase.terms, parts_->watch, all_coefs);
  field.alignment = parts_->alignment;
  std::vector<double>& s = field.phase.s;
  for (int e = 0; e < mesh.num_elems(); ++e) {
    const Eigen::MatrixXd& coefs = all_coefs[e];
    s.insert(s.end(), coefs.col(0).begin(), coefs.col(0).end());
    field.coef_offsets.push_back(static_cast<int>(s.size()));
  }
  parts_->watch.lap("coefficients");

  const PhaseForm& form = field.phase;
  report.set("solve.method", enum_name(field.method));
  report.set("solve.num_elements", mesh.num_elems());
  report.set("solve.num_unknowns", parts_->system.map().num_unknowns);
  report.set("solve.residual", parts_->system.residual(state.dofs));
  std::vector<double> node_valences, corner_valences;
  for (const PhaseNode& node : form.prescribed.nodes) node_valences.push_back(node.valence);
  for (const CornerValence& corner : form.prescribed.corners) corner_valences.push_back(corner.valence);
  report.set("phase.num_nodes", form.terms.nodes.size());
  report.set("phase.node_valences", node_valences);
  report.set("phase.corner_valences", corner_valences);
  report.set("phase.num_corner_angles", form.terms.corner_angles.size());
  const std::vector<double> hole_winding(form.hole_winding.begin(), form.hole_winding.end());
  report.set("phase.hole_winding", hole_winding);
  report.set("phase.best_hole_winding", form.best_hole_winding);
  report.set("phase.hole_periods", form.hole_periods);
  report.set("phase.hole_winding_energy", form.hole_winding_energy);
  return field;
}

PhaseEnergy PhaseSolver::energy(const PhaseNodes& asked, const std::vector<int>& winding_offsets) {
  // A minimisation starts where the energy was computed before.
  if (const auto& known = parts_->known_energy;
      known && known->asked == asked && known->hole_winding_offsets == winding_offsets)
    return known->energy;
  const State state = this->state(asked, winding_offsets);
  const MeshContext& context = parts_->context;
  if (!parts_->locator) parts_->locator = std::make_unique<mesh::Locator>(*context.mesh, context.maps);
  PhaseEnergy energy;
  energy.value = state.remainder_energy +
                 explicit_energy(context.mesh->face, asked, state.form.terms, parts_->given->boundary.apex_turns());
  for (std::size_t k = 0; k < asked.nodes.size(); ++k) {
    const mesh::Location at = locate_node(*parts_->locator, *context.mesh, asked.nodes[k].position);
    const Eigen::VectorXd s = parts_->system.coefs(at.elem, state.dofs);
    const Vec2 slope =
        field::remainder_sample(context.maps[at.elem], parts_->elem_order[at.elem], s.data(), at.xi).slope;
    energy.gradient.push_back(phase_energy_gradient(state.form.terms, static_cast<int>(k), slope));
  }
  parts_->known_energy = {asked, winding_offsets, energy};
  return energy;
}

Field solve_phase(const TriMesh& mesh, const std::vector<int>& elem_order, const PhaseNodes& asked,
                  const std::vector<int>& winding_offsets, Report& report) {
  return PhaseSolver(mesh, elem_order).solve(asked, winding_offsets, report);
}

Field solve_phase(const TriMesh& mesh, const std::vector<int>& elem_order, const PhaseNodes& asked, Report& report) {
  return solve_phase(mesh, elem_order, asked, {}, report);
}

}  // namespace quadrille::galerkin
