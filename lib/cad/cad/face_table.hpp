#pragma once
// The faces of a CAD file for a person, as a table, and for programs, as keys of a report. No OpenCASCADE types.

#include <string>

#include "base/report.hpp"
#include "cad/loaded_face.hpp"

namespace quadrille::cad {

/// One line for each face and, below it, one for each of its edges: number, kind, length, place, name; for faces also
/// part and layer.
std::string face_table(const FaceList& list);

/// Adds the keys `list.*` (formats/report.md), and a warning that names the faces which could not be built.
void report_faces(const FaceList& list, Report& report);

}  // namespace quadrille::cad
