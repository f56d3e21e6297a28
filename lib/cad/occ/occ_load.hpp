#pragma once
// Reads a CAD file into an OpenCASCADE shape. Only occ_load_*.cpp include OpenCASCADE's readers, one source file for
// each format, so that a program is linked only with the libraries of the formats that it reads.

#include <string>

#include "occ/kernel_format.hpp"
#include "occ/occ_model.hpp"

namespace quadrille::occ {

/// Reads without OpenCASCADE's shape healing: errors of the file are reported, not repaired silently. Throws
/// FormatError with `name` if nothing can be read.
OccModel occ_load(const KernelFormat& format, const std::string& bytes, const std::string& name);

/// The readers behind occ_load.
OccModel occ_load_step(const std::string& bytes, const std::string& name);
OccModel occ_load_iges(const std::string& bytes, const std::string& name);
OccModel occ_load_brep(const std::string& bytes, const std::string& name);

/// Switches OpenCASCADE's healing off in the readers of STEP and IGES, for the whole process.
void switch_healing_off();

}  // namespace quadrille::occ
