#pragma once
// The functions of the CAD kernel for one file format. No OpenCASCADE types.

#include <string>

#include "cad/file_kind.hpp"
#include "model/cad_face.hpp"

namespace quadrille::occ {

struct OccModel;

struct KernelFormat {
  cad::CadFormat format;
  OccModel (*read)(const std::string& bytes, const std::string& name);
  std::string (*write)(const CadFace& face);  ///< occ/write_cad.hpp; null if the format is not written
};

/// The formats. Each function is in the source file of its reader: a program that calls one of them is linked with the
/// libraries of that format alone.
const KernelFormat& step_format();
const KernelFormat& iges_format();
const KernelFormat& brep_format();

}  // namespace quadrille::occ
