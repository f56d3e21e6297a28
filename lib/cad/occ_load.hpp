#pragma once
// Reads a CAD file into an OpenCASCADE shape. Only occ_load*.cpp include OpenCASCADE's readers.

#include <string>

#include "cad/file_kind.hpp"
#include "cad/occ_model.hpp"

namespace quadrille::cad {

/// Reads without OpenCASCADE's shape healing: errors of the file are reported, not repaired silently. Throws
/// FormatError with `name` if nothing can be read.
OccModel occ_load(CadFormat format, const std::string& bytes, const std::string& name);

/// The readers behind occ_load, one source file each.
OccModel occ_load_step(const std::string& bytes, const std::string& name);
OccModel occ_load_iges(const std::string& bytes, const std::string& name);

}  // namespace quadrille::cad
