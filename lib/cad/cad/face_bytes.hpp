#pragma once
// Exact serialisation of what cad2tri and the programs that are linked with the CAD kernel pass to each other: a
// request, a LoadedFace with its Report, or a FaceList. Not a file format.

#include <string>

#include "base/report.hpp"
#include "cad/cad_request.hpp"
#include "cad/loaded_face.hpp"

namespace quadrille::cad {

/// Serialises the face and the report.
std::string to_bytes(const LoadedFace& loaded, const Report& report);

/// Returns the face and adds the contents of the serialised report to `report`. Throws Defect for bytes that were not
/// written by to_bytes.
LoadedFace from_bytes(const std::string& bytes, Report& report);

/// The same for a list of faces.
std::string to_bytes(const FaceList& list);
FaceList list_from_bytes(const std::string& bytes);

/// The same for a request.
std::string to_bytes(const CadRequest& request);
CadRequest request_from_bytes(const std::string& bytes);

}  // namespace quadrille::cad
