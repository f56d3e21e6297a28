#include "galerkin/solve_laplace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/warning_codes.hpp"
#include "field/boundary_values.hpp"
#include "galerkin/aligned_field.hpp"
#include "galerkin/discretization.hpp"
#include "galerkin/hybridised.hpp"
#include "surface/positions.hpp"

namespace quadrille::galerkin {

namespace {

std::unique_ptr<Discretization> make_discretization(FieldMethod method, const MeshContext& context, BoundaryData data,
                                                    int num_threads, const field::AlignmentTerm* term = nullptr,
                                                    ValuesInElement f = {}) {
  if (method == FieldMethod::dg && term) throw UsageError("crosses can be aligned with continuous elements only");
  if (method == FieldMethod::dg) return std::make_unique<HybridisedGalerkin>(context, std::move(data), num_threads);
  return std::make_unique<ContinuousGalerkin>(context, std::move(data), num_threads, term, std::move(f));
}

// The solution is correct, but its zeros form curves and determine no layout.
void warn_of_line_field(const CadFace& face, Report& report) {
  if (!field::is_line_field(face)) return;
  report.warn(warning::field_vanishes_on_curves,
              "all sides are straight and at multiples of 45 degrees to each other, of both parities: the harmonic "
              "field vanishes on curves instead of at points; critpoints will choose corner valences by rule, for "
              "fieldsolve --nodes");
}

// Continuous elements would smear a jump over an element, and no refinement would reveal the error.
void require_no_jump(const CadFace& face, const std::vector<Lifting>& jumps) {
  if (jumps.empty()) return;
  throw ComputeError(fmt::format(
      "the boundary data jump at {} {}, the first at {}: continuous elements cannot follow that; use "
      "--corners lift or --method dg",
      jumps.size(), jumps.size() == 1 ? "corner" : "corners", surface::position_text(face, jumps.front().apex)));
}

}  // namespace

LaplaceSolver::LaplaceSolver(const TriMesh& mesh, BoundaryData data, FieldMethod method)
    : context_(std::make_unique<MeshContext>(mesh)),
      method_(method),
      discretization_(make_discretization(method, *context_, std::move(data), 1)) {}

LaplaceSolver::LaplaceSolver(const TriMesh& mesh, const LaplaceOptions& options)
    : context_(std::make_unique<MeshContext>(mesh)),
      method_(options.method),
      liftings_(field::corner_liftings(mesh.face)),
      alignment_(options.alignment) {
  if (options.corners == CornerData::dg) {
    if (options.method == FieldMethod::cg) require_no_jump(mesh.face, liftings_);
    liftings_.clear();
  }
  ValuesInElement f;
  if (!alignment_.empty()) {
    term_ = std::make_unique<const field::AlignmentTerm>(alignment_);
    f = right_side_beside(*term_, {&liftings_}, true);
  }
  discretization_ = make_discretization(method_, *context_, field::BoundaryValues(mesh, liftings_), options.num_threads,
                                        term_.get(), std::move(f));
}

Field LaplaceSolver::solve(const std::vector<int>& elem_order, Report& report) {
  const TriMesh& mesh = *context_->mesh;
  if (elem_order.size() != context_->maps.size()) throw Defect("the order map does not fit the mesh");
  context_->progress = report.progress();
  const Solution solution = discretization_->solve(elem_order);
  if (!std::isfinite(solution.residual))
    throw ComputeError("the solution is not finite: some element has a folded shape");

  Field field;
  field.provenance = mesh.provenance;
  field.mesh = mesh;
  field.method = method_;
  field.elem_order = elem_order;
  field.liftings = liftings_;
  field.alignment = alignment_;
  field.coef_offsets.push_back(0);
  for (int e = 0; e < mesh.num_elems(); ++e) {
    const Eigen::MatrixXd& coefs = solution.elem_coefs[e];
    field.u.insert(field.u.end(), coefs.col(0).begin(), coefs.col(0).end());
    field.v.insert(field.v.end(), coefs.col(1).begin(), coefs.col(1).end());
    field.coef_offsets.push_back(static_cast<int>(field.u.size()));
  }
  report.set("solve.method", enum_name(method_));
  report.set("solve.num_elements", mesh.num_elems());
  report.set("solve.num_unknowns", solution.num_unknowns);
  report.set("solve.num_liftings", liftings_.size());
  report.set("solve.residual", solution.residual);
  for (const Lap& lap : solution.laps) {
    report.set("solve.timings." + lap.phase + ".cpu_seconds", lap.cpu_seconds);
    report.set("solve.timings." + lap.phase + ".wall_seconds", lap.wall_seconds);
  }
  return field;
}

Field solve_laplace(const TriMesh& mesh, const std::vector<int>& elem_order, const LaplaceOptions& options,
                    Report& report) {
  warn_of_line_field(mesh.face, report);
  return LaplaceSolver(mesh, options).solve(elem_order, report);
}

Field solve_laplace(const TriMesh& mesh, const std::vector<int>& elem_order, Report& report) {
  return solve_laplace(mesh, elem_order, {}, report);
}

LaplaceOptions options_of(const Field& field) {
  LaplaceOptions options;
  options.method = field.method;
  options.alignment = field.alignment;
  if (field.liftings.empty() && !field::corner_liftings(field.mesh.face).empty()) options.corners = CornerData::dg;
  return options;
}

}  // namespace quadrille::galerkin
