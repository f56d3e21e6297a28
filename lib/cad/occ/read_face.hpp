#pragma once
// Reads one face, planar or curved, or a list of all faces, from a CAD file. No OpenCASCADE types.

#include <string>

#include "base/report.hpp"
#include "cad/loaded_face.hpp"
#include "occ/kernel_format.hpp"

namespace quadrille::occ {

/// Reads and heals the chosen face of a CAD file; `bytes`: contents of the file, `name`: its file name, for messages.
/// Throws FormatError, with the error and its position, unless the choice is exactly one valid planar face.
/// Construction points and curves beside the face are reported as warnings. OpenCASCADE's readers can crash on
/// malformed files, and the process that calls them takes long to start: tools call cad::load_face_guarded().
cad::LoadedFace read_face(const KernelFormat& format, const std::string& bytes, const std::string& name,
                          const cad::LoadOptions& options, Report& report);

/// Reads the chosen face, planar or curved, in space; as cad::load_space_face_guarded().
SpaceFace read_space_face(const KernelFormat& format, const std::string& bytes, const std::string& name,
                          const cad::LoadOptions& options, Report& report);

/// One of the two: the file is read once, and the face's surface decides.
cad::AnyFace read_any_face(const KernelFormat& format, const std::string& bytes, const std::string& name,
                           const cad::LoadOptions& options, Report& report);

/// The main function of the program of one format (cad/load_face.hpp), without its input and output: does what
/// cad::to_bytes(CadRequest) asks for and returns the face and its report, the list of faces, or the bytes of a file.
std::string answer_request(const KernelFormat& format, const std::string& request);

}  // namespace quadrille::occ
