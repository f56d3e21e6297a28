// Private helper of cad2tri, like cad2tri-step: reads the faces in which a plane cuts the solids of a file of any
// format.

#include "base/child_process.hpp"
#include "cad/file_kind.hpp"
#include "cad/loaded_face.hpp"
#include "occ/occ_section.hpp"
#include "occ/read_face.hpp"

namespace {

using namespace quadrille;

const occ::KernelFormat& format_of(const cad::CadRequest& request) {
  switch (cad::cad_format(request.bytes, request.name)) {
    case cad::CadFormat::step:
      return occ::step_format();
    case cad::CadFormat::iges:
      return occ::iges_format();
    case cad::CadFormat::brep:
      break;
  }
  return occ::brep_format();
}

}  // namespace

int main() {
  answer_parent([](const std::string& request) {
    occ::KernelFormat format = format_of(cad::request_from_bytes(request));
    format.cut = occ::section;
    return occ::answer_request(format, request);
  });
}
