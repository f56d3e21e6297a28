#pragma once
// The functions of the CAD kernel for one file format. No OpenCASCADE types.

#include <string>

#include "base/report.hpp"
#include "cad/file_kind.hpp"
#include "cad/loaded_face.hpp"
#include "model/cad_face.hpp"

namespace quadrille::occ {

struct OccModel;

struct KernelFormat {
  cad::CadFormat format;
  OccModel (*read)(const std::string& bytes, const std::string& name);
  std::string (*write)(const CadFace& face);  ///< occ/write_cad.hpp; null if the format is not written
  /// occ/occ_section.hpp; null but in the program that cuts, because the libraries for it are slow to load
  OccModel (*cut)(const OccModel& model, const cad::SectionPlane& plane, const std::string& name,
                  Report& report) = nullptr;
};

/// The formats. Each function is in the source file of its reader: a program that calls one of them is linked with the
/// libraries of that format alone.
const KernelFormat& step_format();
const KernelFormat& iges_format();
const KernelFormat& brep_format();

}  // namespace quadrille::occ
