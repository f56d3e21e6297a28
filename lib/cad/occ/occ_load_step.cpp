#include <fmt/format.h>

#include <Interface_Static.hxx>
#include <STEPConstruct_UnitContext.hxx>
#include <STEPControl_Reader.hxx>
#include <StepBasic_ConversionBasedUnitAndLengthUnit.hxx>
#include <StepBasic_SiUnitAndLengthUnit.hxx>
#include <StepData_StepModel.hxx>
#include <StepGeom_GeomRepContextAndGlobUnitAssCtxAndGlobUncertaintyAssCtx.hxx>
#include <StepGeom_GeometricRepresentationContextAndGlobalUnitAssignedContext.hxx>
#include <StepRepr_GlobalUncertaintyAssignedContext.hxx>
#include <StepRepr_GlobalUnitAssignedContext.hxx>
#include <StepShape_EdgeLoop.hxx>
#include <StepShape_FaceBound.hxx>
#include <StepShape_FaceSurface.hxx>
#include <StepShape_SolidModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <cctype>
#include <cmath>
#include <sstream>

#include "base/error.hpp"
#include "base/name_text.hpp"
#include "model/length_scale.hpp"
#include "occ/occ_model.hpp"
#include "occ/occ_si_lengths.hpp"
#include "occ/occ_step_placements.hpp"
#include "occ/write_cad.hpp"

namespace quadrille::occ {
namespace {

std::string text_of(const Handle(TCollection_HAsciiString) & s) { return s.IsNull() ? std::string() : s->ToCString(); }

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::string si_length_name(const Handle(StepBasic_SiUnit) & unit) {
  if (!unit->HasPrefix()) return "metre";
  for (const SiLength& known : si_lengths)
    if (known.prefix == unit->Prefix()) return known.name;
  return "metre with a prefix";
}

// Names of other units are free: one of a known length gets its usual name, "inch" for "INCHES".
std::string other_length_name(const std::string& text, double metres) {
  for (const LengthUnit& known : length_units)
    if (std::abs(metres / known.metres - 1) < 1e-9) return std::string(known.name);
  return text.empty() ? fmt::format("unit of {} m", metres) : lower(text);
}

std::string length_name(const Handle(StepRepr_GlobalUnitAssignedContext) & context, double metres) {
  for (int i = 1; i <= context->NbUnits(); ++i) {
    const Handle(StepBasic_NamedUnit) unit = context->UnitsValue(i);
    if (const auto inch = Handle(StepBasic_ConversionBasedUnitAndLengthUnit)::DownCast(unit); !inch.IsNull())
      return other_length_name(text_of(inch->Name()), metres);
    if (const auto si = Handle(StepBasic_SiUnitAndLengthUnit)::DownCast(unit); !si.IsNull()) return si_length_name(si);
  }
  return "unknown";
}

struct FileUnit {
  std::string name = "unknown";
  double millimetres = 0;  ///< 0: not stated in the file
  double tolerance = 0;
};

// The length unit of one representation context; millimetres = 0 if the entity is no such context.
FileUnit unit_of(const Handle(Standard_Transient) & entity) {
  Handle(StepRepr_GlobalUnitAssignedContext) units;
  Handle(StepRepr_GlobalUncertaintyAssignedContext) uncertainty;
  using Full = StepGeom_GeomRepContextAndGlobUnitAssCtxAndGlobUncertaintyAssCtx;
  using Short = StepGeom_GeometricRepresentationContextAndGlobalUnitAssignedContext;
  if (const auto full = Handle(Full)::DownCast(entity); !full.IsNull()) {
    units = full->GlobalUnitAssignedContext();
    uncertainty = full->GlobalUncertaintyAssignedContext();
  } else if (const auto plain = Handle(Short)::DownCast(entity); !plain.IsNull()) {
    units = plain->GlobalUnitAssignedContext();
  }
  FileUnit unit;
  if (units.IsNull() || units->Units().IsNull()) return unit;
  STEPConstruct_UnitContext factors;
  factors.ComputeFactors(units);
  if (!factors.LengthDone() || !(factors.LengthFactor() > 0)) return unit;
  unit.millimetres = factors.LengthFactor();
  unit.name = length_name(units, unit.millimetres / 1000);
  if (!uncertainty.IsNull() && factors.ComputeTolerance(uncertainty) == 0 && factors.HasUncertainty())
    unit.tolerance = factors.Uncertainty();
  return unit;
}

// The length unit of the model; a file with several length units is refused.
FileUnit length_unit(const StepData_StepModel& model, const std::string& name) {
  FileUnit found;
  for (int i = 1; i <= model.NbEntities(); ++i) {
    const FileUnit unit = unit_of(model.Value(i));
    if (unit.millimetres == 0) continue;
    if (found.millimetres == 0) found = unit;
    if (unit.millimetres != found.millimetres)
      throw FormatError(name + ": the file mixes length units (" + found.name + " and " + unit.name + ")");
    found.tolerance = std::max(found.tolerance, unit.tolerance);
  }
  return found;
}

// The number of edges that the loops of a face refer to, whether they can be built or not.
int num_edges(const StepShape_Face& face) {
  int edges = 0;
  if (face.Bounds().IsNull()) return 0;
  for (int i = 1; i <= face.NbBounds(); ++i) {
    const Handle(StepShape_FaceBound) bound = face.BoundsValue(i);
    const auto loop = bound.IsNull() ? nullptr : Handle(StepShape_EdgeLoop)::DownCast(bound->Bound());
    // A missing loop, or one of another kind, counts as one edge, so that its loss is detected.
    edges += loop.IsNull() || loop->EdgeList().IsNull() ? 1 : loop->NbEdgeList();
  }
  return edges;
}

// "#40 'lid'"
std::string text_of_face(const StepData_StepModel& file, const Handle(StepRepr_RepresentationItem) & face) {
  const std::string name = clean_name(text_of(face->Name()));
  return fmt::format("#{}{}", file.IdentLabel(face), name.empty() ? "" : " '" + name + "'");
}

void add_face(const StepData_StepModel& file, const Handle(Standard_Transient) & entity,
              const Handle(Transfer_TransientProcess) & process, OccModel& model) {
  const auto face = Handle(StepShape_FaceSurface)::DownCast(entity);
  const TopoDS_Shape shape = TransferBRep::ShapeResult(process, entity);
  if (shape.IsNull())
    model.not_built.push_back(text_of_face(file, face));
  else
    model.num_edges[shape.TShape().get()] = num_edges(*face);
}

void collect(const STEPControl_Reader& reader, OccModel& model) {
  const Handle(StepData_StepModel) file = reader.StepModel();
  const Handle(Transfer_TransientProcess) process = reader.WS()->TransferReader()->TransientProcess();
  for (int i = 1; i <= file->NbEntities(); ++i) {
    const Handle(Standard_Transient) entity = file->Value(i);
    const bool is_face = entity->IsKind(STANDARD_TYPE(StepShape_FaceSurface));
    model.num_faces += is_face;
    if (is_face) add_face(*file, entity, process, model);
    model.num_solids += entity->IsKind(STANDARD_TYPE(StepShape_SolidModel));
  }
  add_step_labels(*file, process, model);
}

}  // namespace

OccModel occ_load_step(const std::string& bytes, const std::string& name) {
  switch_healing_off();
  STEPControl_Reader reader;
  // Use the curves in space only: the curves in the parameter plane (pcurves) are redundant and often less accurate.
  Interface_Static::SetIVal("read.surfacecurve.mode", -3);
  // The reader assumes UTF-8 and corrupts other encodings.
  std::istringstream stream(utf8_or_latin1(bytes));
  if (reader.ReadStream(name.c_str(), stream) != IFSelect_RetDone)
    throw FormatError(name + ": the STEP file cannot be parsed");
  require_readable_placements(*reader.StepModel(), name);
  OccModel model;
  // Lengths are converted to the target unit, a global setting that a previous reader may have changed.
  reader.SetSystemLengthUnit(1.0);
  const FileUnit unit = length_unit(*reader.StepModel(), name);
  if (unit.millimetres > 0) {
    // The reader multiplies coordinates by the millimetres per unit and divides them by this value: the factor is
    // exactly 1.
    reader.SetSystemLengthUnit(unit.millimetres);
    model.length_unit = unit.name;
    model.metres_per_unit = unit.millimetres / 1000;
  }
  if (unit.tolerance > 0) model.tolerance = unit.tolerance;
  reader.TransferRoots();
  model.shape = reader.OneShape();
  collect(reader, model);
  return model;
}

const KernelFormat& step_format() {
  static const KernelFormat format{cad::CadFormat::step, occ_load_step, step_of_face};
  return format;
}

}  // namespace quadrille::occ
