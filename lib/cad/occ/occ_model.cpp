#include "occ/occ_model.hpp"

#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <algorithm>
#include <array>
#include <ios>
#include <stdexcept>

#include "base/error.hpp"
#include "base/name_text.hpp"
#include "occ/occ_quiet.hpp"

namespace quadrille::occ {

std::string given_name(const Handle(TCollection_HAsciiString) & text) {
  constexpr std::array automatic{"NONE", "none", "Open CASCADE * translator *", "=>[*]"};
  const std::string name = text.IsNull() ? std::string() : clean_name(text->ToCString());
  const auto fits = [&](const char* pattern) { return matches_wildcard(name, pattern); };
  return std::any_of(automatic.begin(), automatic.end(), fits) ? std::string() : name;
}

namespace {

int count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  int n = 0;
  for (TopExp_Explorer e(shape, kind); e.More(); e.Next()) ++n;
  return n;
}

}  // namespace

OccModel occ_load(const KernelFormat& format, const std::string& bytes, const std::string& name) {
  const std::string kind = cad::format_name(format.format);
  quiet_kernel();
  try {
    OccModel model = format.read(bytes, name);
    if (model.shape.IsNull() && !model.not_built.empty())
      throw FormatError(name + ": no face can be built from what the file says, first: " + model.not_built.front());
    if (model.shape.IsNull()) throw FormatError(name + ": the " + kind + " file holds no shape");
    model.num_faces = std::max(model.num_faces, count(model.shape, TopAbs_FACE));
    model.num_solids = std::max(model.num_solids, count(model.shape, TopAbs_SOLID));
    return model;
  } catch (const Standard_Failure& e) {
    throw FormatError(name + ": the " + kind + " file cannot be read: " + e.GetMessageString());
  } catch (const std::ios::failure&) {
    throw FormatError(name + ": the " + kind + " file is broken or truncated");
  } catch (const std::length_error&) {
    throw FormatError(name + ": the " + kind + " file is broken: a size in it is absurd");
  }
}

}  // namespace quadrille::occ
