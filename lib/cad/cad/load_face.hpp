#pragma once
// Reads one planar face from a CAD file (STEP, IGES, BREP), and writes one. The work is done in a program for each
// format (cad2tri-step, cad2tri-iges, cad2tri-brep in libexec), because loading the libraries of the CAD kernel takes
// most of the time of a small shape, and because its readers can crash on malformed files.

#include <string>

#include "base/report.hpp"
#include "cad/file_kind.hpp"
#include "cad/loaded_face.hpp"

namespace quadrille::cad {

/// Reads and heals the chosen face of a CAD file; `bytes`: contents of the file, `name`: its file name, for the
/// extension and for messages. Throws FormatError, with the error and its position, unless the choice is exactly one
/// valid planar face; a crash of the reader is a FormatError too. Construction points and curves beside the face are
/// reported as warnings. Throws Error (exit 70) if the program of the format cannot be started.
LoadedFace load_face_guarded(const std::string& bytes, const std::string& name, const LoadOptions& options,
                             Report& report);

/// All faces of a CAD file, planar or not, numbered from 0, read likewise.
FaceList list_faces_guarded(const std::string& bytes, const std::string& name);

/// The face as a file in `format`, STEP or BREP (occ/write_cad.hpp). Throws ComputeError if the kernel cannot write it.
std::string file_of_face(const CadFace& face, CadFormat format);

// The faces of a CAD file for a person, as a table, and for programs, as keys of a report. No OpenCASCADE types.

/// One line for each face and, below it, one for each of its edges: number, kind, length, place, name; for faces also
/// part and layer.
std::string face_table(const FaceList& list);

/// Adds the keys `list.*` (formats/report.md), and a warning that names the faces which could not be built.
void report_faces(const FaceList& list, Report& report);

}  // namespace quadrille::cad
