#include "cad/occ_load.hpp"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <XSAlgo.hxx>
#include <XSAlgo_AlgoContainer.hxx>
#include <sstream>
#include <stdexcept>

#include "base/error.hpp"
#include "cad/occ_quiet.hpp"

namespace quadrille::cad {
namespace {

// Replaces OpenCASCADE's shape healing: every shape stays as the file describes it.
class NoHealing : public XSAlgo_AlgoContainer {
 public:
  TopoDS_Shape ProcessShape(const TopoDS_Shape& shape, const Standard_Real, const Standard_Real, const Standard_CString,
                            const Standard_CString, Handle(Standard_Transient) &, const Message_ProgressRange&,
                            const Standard_Boolean) const override {
    return shape;
  }
  void MergeTransferInfo(const Handle(Transfer_TransientProcess) &, const Handle(Standard_Transient) &,
                         const Standard_Integer) const override {}
};

int count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  int n = 0;
  for (TopExp_Explorer e(shape, kind); e.More(); e.Next()) ++n;
  return n;
}

OccModel occ_load_brep(const std::string& bytes) {
  OccModel model;
  // The readers do not detect the end of the file and would continue for as long as a wrong count states.
  std::istringstream stream(bytes + "\n");
  stream.exceptions(std::ios::failbit | std::ios::badbit);
  if (bytes.substr(0, 200).find("Open CASCADE Topology V") != std::string::npos)
    BinTools::Read(model.shape, stream);
  else
    BRepTools::Read(model.shape, stream, BRep_Builder());
  return model;
}

OccModel read(CadFormat format, const std::string& bytes, const std::string& name) {
  if (format == CadFormat::brep) return occ_load_brep(bytes);
  XSAlgo::Init();
  XSAlgo::SetAlgoContainer(new NoHealing);
  return format == CadFormat::step ? occ_load_step(bytes, name) : occ_load_iges(bytes, name);
}

}  // namespace

OccModel occ_load(CadFormat format, const std::string& bytes, const std::string& name) {
  quiet_kernel();
  try {
    OccModel model = read(format, bytes, name);
    if (model.shape.IsNull() && !model.not_built.empty())
      throw FormatError(name + ": no face can be built from what the file says, first: " + model.not_built.front());
    if (model.shape.IsNull()) throw FormatError(name + ": the " + format_name(format) + " file holds no shape");
    model.num_faces = std::max(model.num_faces, count(model.shape, TopAbs_FACE));
    model.num_solids = std::max(model.num_solids, count(model.shape, TopAbs_SOLID));
    return model;
  } catch (const Standard_Failure& e) {
    throw FormatError(name + ": the " + format_name(format) + " file cannot be read: " + e.GetMessageString());
  } catch (const std::ios::failure&) {
    throw FormatError(name + ": the " + format_name(format) + " file is broken or truncated");
  } catch (const std::length_error&) {
    throw FormatError(name + ": the " + format_name(format) + " file is broken: a size in it is absurd");
  }
}

}  // namespace quadrille::cad
