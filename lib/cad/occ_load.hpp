#pragma once
// CAD file -> OpenCASCADE shape. Only occ_load*.cpp include OpenCASCADE's readers.

#include <string>

#include "cad/file_kind.hpp"
#include "cad/occ_model.hpp"

namespace quadrille::cad {

/// Reads without OpenCASCADE's shape healing: what is wrong in the file shall be seen, not repaired behind the back.
/// Throws FormatError with `name` where nothing can be read.
OccModel occ_load(CadFormat format, const std::string& bytes, const std::string& name);

}  // namespace quadrille::cad
