#pragma once
// Reads one face, planar or curved, or the section of solids from a CAD file (STEP, IGES, BREP), and writes a planar
// face. The work is done in a program for each format (cad2tri-step, cad2tri-iges, cad2tri-brep in libexec), that on
// sections in one for all of them (cad2tri-section), because loading the libraries of the
// CAD kernel takes most of the time of a small shape, and because its readers can crash on malformed files.

#include <functional>
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

/// Reads the chosen face, planar or curved, in space (model/space_face.hpp), likewise. Throws FormatError for faces
/// without an image in the plane (closed ones, and those with a handle), with kinks inside, and for those of which the
/// CAD kernel finds no triangles.
SpaceFace load_space_face_guarded(const std::string& bytes, const std::string& name, const LoadOptions& options,
                                  Report& report);

/// As load_face_guarded if the chosen face is planar, else as load_space_face_guarded; the file is read once.
AnyFace load_any_face_guarded(const std::string& bytes, const std::string& name, const LoadOptions& options,
                              Report& report);

/// The kind of the surface of the chosen face, as in ListedShape: "plane" for faces of one plane too.
std::string face_kind_guarded(const std::string& bytes, const std::string& name, const std::string& face);

/// All faces of a CAD file, planar or not, numbered from 0, read likewise; with a section, its faces.
FaceList list_faces_guarded(const std::string& bytes, const std::string& name, const SectionPlane& section = {});

/// The plane of a text: "z=0.5", likewise x and y, or "NX,NY,NZ@X,Y,Z", its normal and one of its points; no plane if
/// the text is empty. Throws UsageError for other texts.
SectionPlane section_plane(const std::string& text);

/// The face as a file in `format`, STEP or BREP (occ/write_cad.hpp). Throws ComputeError if the kernel cannot write it.
std::string file_of_face(const CadFace& face, CadFormat format);

// The faces of a CAD file for a person, as a table, and for programs, as keys of a report. No OpenCASCADE types.

/// One line for each face that `shows` and, below it, one for each of its edges: number, kind, length, place, name; for
/// faces also part and layer.
std::string face_table(
    const FaceList& list, const std::function<bool(const ListedFace&)>& shows = [](const ListedFace&) { return true; });

/// Adds the keys `list.*` (formats/report.md), and a warning that names the faces which could not be built.
void report_faces(const FaceList& list, Report& report);

}  // namespace quadrille::cad
