#include "api/fields.hpp"

#include "adapt/adapt_loop.hpp"
#include "field/error_estimate.hpp"
#include "field/evaluate.hpp"
#include "galerkin/phase_request.hpp"
#include "galerkin/solve_laplace.hpp"
#include "galerkin/solve_phase.hpp"

namespace quadrille::api {
namespace {

Field finished(Field start, const FieldOptions& options, Report& report) {
  if (!options.adapt) {
    start.elem_error = field::error_estimate(start);
    return start;
  }
  adapt::AdaptOptions adapting;
  adapting.target_error = options.target_error;
  adapting.num_threads = options.num_threads;
  adapting.validate();
  return adapt::adapt_loop(start, adapting, report);
}

Field with_warnings(Field field, const TriMesh& mesh, const Report& report, std::vector<std::string>* warnings) {
  field.provenance = mesh.provenance;
  if (warnings)
    for (const Report::Warning& warning : report.warnings()) warnings->push_back(warning.message);
  return field;
}

std::optional<FieldValue> as_value(const field::PointSample& sample) {
  if (sample.at.elem < 0) return std::nullopt;
  return FieldValue{sample.value, angle_of(sample.value) / 4};
}

}  // namespace

Field solve_field(const TriMesh& mesh, const FieldOptions& options, std::vector<std::string>* warnings) {
  Report report;
  galerkin::LaplaceOptions solving;
  solving.num_threads = options.num_threads;
  const std::vector<int> orders(mesh.num_elems(), options.order);
  Field start = galerkin::solve_laplace(mesh, orders, solving, report);
  return with_warnings(finished(std::move(start), options, report), mesh, report, warnings);
}

Field solve_field_of_nodes(const TriMesh& mesh, const CriticalPoints& points, const FieldOptions& options,
                           std::vector<std::string>* warnings) {
  Report report;
  const std::vector<int> orders(mesh.num_elems(), options.order);
  galerkin::PhaseSolver solver(mesh, orders, options.num_threads);
  galerkin::require_possible(solver, mesh.face, phase_nodes_of(points), "the nodes");
  Field start = solver.solve(phase_nodes_of(points), {points.hole_winding_offsets}, report);
  return with_warnings(finished(std::move(start), options, report), mesh, report, warnings);
}

struct FieldAtPoints::Parts {
  explicit Parts(Field f) : field(std::move(f)), evaluator(field) {}
  Field field;
  field::FieldEvaluator evaluator;
};

FieldAtPoints::FieldAtPoints(Field field) : parts_(std::make_unique<Parts>(std::move(field))) {}
FieldAtPoints::~FieldAtPoints() = default;
FieldAtPoints::FieldAtPoints(FieldAtPoints&&) noexcept = default;
FieldAtPoints& FieldAtPoints::operator=(FieldAtPoints&&) noexcept = default;

const Field& FieldAtPoints::field() const { return parts_->field; }

std::optional<FieldValue> FieldAtPoints::at(Vec2 point) const { return at(std::vector<Vec2>{point}).front(); }

std::vector<std::optional<FieldValue>> FieldAtPoints::at(const std::vector<Vec2>& points) const {
  std::vector<std::optional<FieldValue>> values;
  for (const field::PointSample& sample : parts_->evaluator.values_at(points)) values.push_back(as_value(sample));
  return values;
}

}  // namespace quadrille::api
