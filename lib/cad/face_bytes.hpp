#pragma once
// A CadFace and a Report as bytes, exactly, for the way from a child process to its parent. Not a file format.

#include <string>

#include "base/report.hpp"
#include "model/cad_face.hpp"

namespace quadrille::cad {

std::string to_bytes(const CadFace& face, const Report& report);

/// The face; what the report held is added to `report`. Throws Defect for bytes that to_bytes did not write.
CadFace from_bytes(const std::string& bytes, Report& report);

}  // namespace quadrille::cad
