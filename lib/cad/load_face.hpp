#pragma once
// Reads one planar face from a CAD file (STEP, IGES, BREP). No OpenCASCADE types: the kernel is used in this folder
// only.

#include <string>

#include "base/report.hpp"
#include "cad/loaded_face.hpp"

namespace quadrille::cad {

struct LoadOptions {
  double corner_angle = 0.017453292519943295;  ///< radians; greater tangent jumps are corners of the layout
  double heal_tolerance = -1;                  ///< as in heal::HealOptions
  std::string face = {};                       ///< as the choice of choose_face(); empty: the only face
  double blunt_width = 0;                      ///< as in heal::BluntOptions
};

/// Reads and heals the chosen face of a CAD file; `bytes`: contents of the file, `name`: its file name, for the
/// extension and for messages. Throws FormatError, with the error and its position, unless the choice is exactly one
/// valid planar face. Construction points and curves beside the face are reported as warnings. OpenCASCADE's readers
/// can crash on malformed files: tools must use load_face_guarded().
LoadedFace load_face(const std::string& bytes, const std::string& name, const LoadOptions& options, Report& report);

/// load_face() in a child process (base/child_process); a crash of the child becomes a FormatError. Tools call this
/// function.
LoadedFace load_face_guarded(const std::string& bytes, const std::string& name, const LoadOptions& options,
                             Report& report);

/// All faces of a CAD file, planar or not, numbered from 0, read in a child process likewise.
FaceList list_faces_guarded(const std::string& bytes, const std::string& name);

}  // namespace quadrille::cad
