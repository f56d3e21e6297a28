#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <sstream>

#include "occ/occ_model.hpp"
#include "occ/write_cad.hpp"

namespace quadrille::occ {

OccModel occ_load_brep(const std::string& bytes, const std::string&) {
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

const KernelFormat& brep_format() {
  static const KernelFormat format{cad::CadFormat::brep, occ_load_brep, brep_of_face};
  return format;
}

}  // namespace quadrille::occ
