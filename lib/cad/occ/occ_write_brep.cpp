#include <BRepTools.hxx>
#include <sstream>

#include "occ/occ_blocks.hpp"
#include "occ/occ_quiet.hpp"
#include "occ/write_cad.hpp"

namespace quadrille::occ {

std::string brep_of_face(const CadFace& face) {
  return written_by_kernel("the face", [&] {
    std::ostringstream stream;
    BRepTools::Write(occ_face_shape(face, 1).shape, stream);
    return stream.str();
  });
}

}  // namespace quadrille::occ
