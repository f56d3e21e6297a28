#include "api/fields.hpp"

#include "api/as_input.hpp"
#include "field/evaluate.hpp"
#include "regions/split.hpp"
#include "stage/fieldsolve.hpp"
#include "stage/padapt.hpp"

namespace quadrille::api {
namespace {

Field solved(const TriMesh& mesh, const std::optional<stage::Input<CriticalPoints>>& nodes, const FieldOptions& options,
             std::vector<std::string>* warnings) {
  Run run(options.num_threads);
  stage::FieldsolveOptions solving;
  solving.order = options.order;
  Field field = stage::fieldsolve({as_input(mesh, "the triangle mesh"), {}, {}, nodes}, solving, run);
  if (options.adapt) {
    stage::PadaptOptions adapting;
    adapting.target_error = options.target_error;
    field = stage::padapt(as_input(field, "the field"), adapting, run);
  }
  add_warnings(run, warnings);
  return field;
}

std::optional<FieldValue> as_value(const field::PointSample& sample) {
  if (sample.at.elem < 0) return std::nullopt;
  return FieldValue{sample.value, angle_of(sample.value) / 4};
}

}  // namespace

Field solve_field(const TriMesh& mesh, const FieldOptions& options, std::vector<std::string>* warnings) {
  return solved(mesh, {}, options, warnings);
}

Field solve_field_of_nodes(const TriMesh& mesh, const CriticalPoints& points, const FieldOptions& options,
                           std::vector<std::string>* warnings) {
  return solved(mesh, as_input(points, "the nodes"), options, warnings);
}

struct FieldAtPoints::Parts {
  explicit Parts(Field f) : field(std::move(f)) {
    if (field.mesh.face.num_regions() > 1) fields_of_regions = regions::split(field);
    for (const Field& part : fields_of_regions) evaluators.push_back(std::make_unique<field::FieldEvaluator>(part));
    if (evaluators.empty()) evaluators.push_back(std::make_unique<field::FieldEvaluator>(field));
  }

  Field field;
  std::vector<Field> fields_of_regions;  // empty: there is one
  std::vector<std::unique_ptr<field::FieldEvaluator>> evaluators;
};

FieldAtPoints::FieldAtPoints(Field field) : parts_(std::make_unique<Parts>(std::move(field))) {}
FieldAtPoints::~FieldAtPoints() = default;
FieldAtPoints::FieldAtPoints(FieldAtPoints&&) noexcept = default;
FieldAtPoints& FieldAtPoints::operator=(FieldAtPoints&&) noexcept = default;

const Field& FieldAtPoints::field() const { return parts_->field; }

std::optional<FieldValue> FieldAtPoints::at(Vec2 point) const { return at(std::vector<Vec2>{point}).front(); }

std::vector<std::optional<FieldValue>> FieldAtPoints::at(const std::vector<Vec2>& points) const {
  std::vector<std::optional<FieldValue>> values(points.size());
  for (const auto& evaluator : parts_->evaluators) {
    const std::vector<field::PointSample> samples = evaluator->values_at(points);
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!values[i]) values[i] = as_value(samples[i]);
  }
  return values;
}

}  // namespace quadrille::api
