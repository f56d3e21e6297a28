#include <fmt/format.h>

#include <APIHeaderSection_MakeHeader.hxx>
#include <Interface_Static.hxx>
#include <STEPConstruct.hxx>
#include <STEPControl_Writer.hxx>
#include <StepBasic_Product.hxx>
#include <StepBasic_SiUnitAndLengthUnit.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <Transfer_FinderProcess.hxx>
#include <XSControl_TransferWriter.hxx>
#include <XSControl_WorkSession.hxx>
#include <cmath>
#include <sstream>

#include "base/error.hpp"
#include "occ/occ_blocks.hpp"
#include "occ/occ_quiet.hpp"
#include "occ/occ_si_lengths.hpp"
#include "occ/write_cad.hpp"

namespace quadrille::occ {
namespace {

struct WrittenUnit {
  const char* name;                    ///< name of the unit in the writer
  double scale;                        ///< factor from the unit of the face
  const SiLength* replaced = nullptr;  ///< the unit, if the writer has no name for it
};

// The unit of the face if the writer or SI has it; coordinates in other units are converted to millimetres.
WrittenUnit written_unit(const CadFace& face) {
  static const std::pair<const char*, double> known[] = {
      {"MM", 1e-3}, {"M", 1.0},       {"INCH", 0.0254}, {"CM", 1e-2}, {"FT", 0.3048},
      {"KM", 1e3},  {"MI", 1609.344}, {"MIL", 2.54e-5}, {"UM", 1e-6}, {"UIN", 2.54e-8}};
  if (!(face.metres_per_unit > 0)) return {"MM", 1};
  for (const auto& [name, metres] : known)
    if (std::abs(face.metres_per_unit / metres - 1) < 1e-9) return {name, 1};
  for (const SiLength& si : si_lengths)
    if (std::abs(face.metres_per_unit / si.metres - 1) < 1e-9) return {"MM", 1, &si};
  if (!(face.metres_per_unit > 1e-15 && face.metres_per_unit < 1e15))  // OpenCASCADE would calculate for ever
    throw ComputeError(fmt::format("a length unit of {} m cannot be written to a STEP file", face.metres_per_unit));
  return {"MM", face.metres_per_unit * 1e3};
}

Handle(TCollection_HAsciiString) text(const std::string& s) { return new TCollection_HAsciiString(s.c_str()); }

// Curves in the parameters of a plane follow from those in space; on curved faces they are written too.
void set_up(STEPControl_Writer& writer, const char* unit, bool is_curved) {
  // With equal source and target units the writer does not scale coordinates and only states the unit.
  writer.Model()->SetLocalLengthUnit(1.0);
  writer.Model()->SetWriteLengthUnit(1.0);
  Interface_Static::SetCVal("write.step.unit", unit);
  Interface_Static::SetIVal("write.surfacecurve.mode", is_curved ? 1 : 0);
  Interface_Static::SetIVal("write.precision.mode", 0);
}

void set_header(const Handle(StepData_StepModel) & model, const std::string& name) {
  APIHeaderSection_MakeHeader header(model);
  header.SetName(text(name));
  header.SetTimeStamp(text("1970-01-01T00:00:00"));
  header.SetAuthorValue(1, text(""));
  header.SetOrganizationValue(1, text(""));
  header.SetPreprocessorVersion(text("Open CASCADE"));
  header.SetOriginatingSystem(text("quadrille"));
  header.SetAuthorisation(text(""));
  header.Apply(model);
}

void set_names(const STEPControl_Writer& writer, const OccShape& shape) {
  const Handle(Transfer_FinderProcess) process = writer.WS()->TransferWriter()->FinderProcess();
  for (const auto& [named, name] : shape.names) {
    const Handle(StepRepr_RepresentationItem) item = STEPConstruct::FindEntity(process, named);
    if (!item.IsNull()) item->SetName(text(name));
  }
}

void set_unit(const StepData_StepModel& model, StepBasic_SiPrefix prefix) {
  for (int i = 1; i <= model.NbEntities(); ++i)
    if (const auto unit = Handle(StepBasic_SiUnitAndLengthUnit)::DownCast(model.Value(i)); !unit.IsNull())
      unit->SetPrefix(prefix);
}

// Replaces the product name, because the writer numbers the products of a process and equal shapes must produce equal
// bytes.
void set_product_name(const StepData_StepModel& model, const std::string& name) {
  for (int i = 1; i <= model.NbEntities(); ++i)
    if (const auto product = Handle(StepBasic_Product)::DownCast(model.Value(i)); !product.IsNull()) {
      product->SetId(text(name));
      product->SetName(text(name));
    }
}

std::string written(const STEPControl_Writer& writer, const Handle(StepData_StepModel) & model) {
  StepData_StepWriter text_writer(model);
  // All digits, so that reading returns the same numbers; suppression of zeros would truncate them.
  text_writer.FloatWriter().SetFormat("%.16E");
  text_writer.FloatWriter().SetZeroSuppress(false);
  text_writer.SendModel(Handle(StepData_Protocol)::DownCast(writer.WS()->Protocol()));
  std::ostringstream stream;
  if (!text_writer.Print(stream)) throw ComputeError("the STEP model cannot be written");
  return stream.str();
}

// `product`: name of the product, and of the file in its header.
std::string step_text(const OccShape& shape, const WrittenUnit& unit, const std::string& product, const CadFace& face) {
  STEPControl_Writer writer;
  set_up(writer, unit.name, face.chart != nullptr);
  writer.SetTolerance(1e-7 * face.diameter * unit.scale);
  const bool has_free_edges = shape.shape.ShapeType() == TopAbs_COMPOUND;
  if (writer.Transfer(shape.shape, has_free_edges ? STEPControl_AsIs : STEPControl_ShellBasedSurfaceModel) !=
      IFSelect_RetDone)
    throw ComputeError("the " + product + " cannot be turned into a STEP model");
  const Handle(StepData_StepModel) model = writer.Model();
  set_header(model, product);
  set_names(writer, shape);
  set_product_name(*model, product);
  if (unit.replaced) set_unit(*model, unit.replaced->prefix);
  return written(writer, model);
}

}  // namespace

bool has_step_unit(const CadFace& face) { return written_unit(face).scale == 1; }

std::string step_of_blocks(const BlockLayout& layout) {
  return written_by_kernel("the blocks", [&] {
    const WrittenUnit unit = written_unit(layout.face);
    return step_text(occ_blocks(layout, unit.scale), unit, "blocks", layout.face);
  });
}

std::string step_of_face(const CadFace& face) {
  return written_by_kernel("the face", [&] {
    const WrittenUnit unit = written_unit(face);
    return step_text(occ_face_shape(face, unit.scale), unit, "face", face);
  });
}

}  // namespace quadrille::occ
