#include "occ/occ_step_placements.hpp"

#include <fmt/format.h>

#include <Geom_CartesianPoint.hxx>
#include <Geom_Direction.hxx>
#include <Standard_Failure.hxx>
#include <StepGeom_CartesianTransformationOperator3d.hxx>
#include <StepRepr_FunctionallyDefinedTransformation.hxx>
#include <StepRepr_MappedItem.hxx>
#include <StepRepr_RepresentationRelationshipWithTransformation.hxx>
#include <StepRepr_Transformation.hxx>
#include <StepToGeom.hxx>
#include <cmath>
#include <gp_Mat.hxx>
#include <gp_Trsf.hxx>

#include "base/error.hpp"

namespace quadrille::occ {
namespace {

using Operator = Handle(StepGeom_CartesianTransformationOperator3d);

// The operator with which `entity` places a part; null if `entity` places nothing by an operator.
Operator operator_of(const Handle(Standard_Transient) & entity) {
  if (const auto item = Handle(StepRepr_MappedItem)::DownCast(entity); !item.IsNull())
    return Operator::DownCast(item->MappingTarget());
  const auto relation = Handle(StepRepr_RepresentationRelationshipWithTransformation)::DownCast(entity);
  return relation.IsNull() ? Operator() : Operator::DownCast(relation->TransformationOperator().Value());
}

gp_XYZ direction(const Handle(StepGeom_Direction) & stated, const gp_XYZ& otherwise) {
  const Handle(Geom_Direction) made = stated.IsNull() ? nullptr : StepToGeom::MakeDirection(stated);
  return made.IsNull() ? otherwise : made->Dir().XYZ();
}

gp_XYZ across(const gp_XYZ& v, const gp_XYZ& unit) { return v - v.Dot(unit) * unit; }

// The linear part of the map (ISO 10303-42, base_axis in three dimensions), without its scale. Throws Standard_Failure
// if axes are parallel.
gp_Mat stated_axes(const StepGeom_CartesianTransformationOperator3d& op) {
  const gp_XYZ z = direction(op.Axis3(), {0, 0, 1});
  const gp_XYZ usual = std::abs(z.X()) > 1 - 1e-12 ? gp_XYZ(0, 1, 0) : gp_XYZ(1, 0, 0);
  const gp_XYZ x = across(direction(op.Axis1(), usual), z).Normalized();
  const gp_XYZ y = across(across(direction(op.Axis2(), {0, 1, 0}), z), x).Normalized();
  return {x, y, z};
}

bool is_read_as(const Operator& op, const gp_Mat& axes) {
  gp_Trsf read;
  if (!StepToGeom::MakeTransformation3d(op, read)) return false;
  double difference = 0;
  for (int row = 1; row <= 3; ++row)
    for (int column = 1; column <= 3; ++column)
      difference = std::max(difference, std::abs(read.Value(row, column) - axes.Value(row, column)));
  return difference < 1e-9;
}

// What is wrong with the operator; empty if nothing is.
std::string fault_of(const Operator& op) {
  const double scale = op->HasScale() ? op->Scale() : 1;
  if (!(std::abs(scale - 1) < 1e-9)) return fmt::format("scales it by {:.6g}", scale);
  try {
    const gp_Mat axes = stated_axes(*op);
    if (axes.Determinant() < 0) return "mirrors it";
    return is_read_as(op, axes) ? "" : "gives axes that OpenCASCADE reads differently";
  } catch (const Standard_Failure&) {
    return "has parallel axes";
  }
}

}  // namespace

void require_readable_placements(const StepData_StepModel& file, const std::string& name) {
  for (int i = 1; i <= file.NbEntities(); ++i) {
    const Operator op = operator_of(file.Value(i));
    const std::string fault = op.IsNull() ? std::string() : fault_of(op);
    if (!fault.empty())
      throw FormatError(
          fmt::format("{}: #{} places a part with #{} CARTESIAN_TRANSFORMATION_OPERATOR_3D, which {}: "
                      "export the part with its own geometry there, or only rotated and moved",
                      name, file.IdentLabel(file.Value(i)), file.IdentLabel(op), fault));
  }
}

}  // namespace quadrille::occ
