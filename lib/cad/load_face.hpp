#pragma once
// One planar face out of a CAD file (STEP, IGES, BREP). No kernel names here: OpenCASCADE stays in this folder.

#include <string>

#include "base/report.hpp"
#include "model/cad_face.hpp"

namespace quadrille::cad {

struct LoadOptions {
  double corner_angle = 0.017453292519943295;  ///< radians; tangent jumps above it are corners of the layout
};

/// Reads the only face of the CAD file held in `bytes`; `name` is its file name, for its extension and for messages.
/// Throws FormatError for anything that is not exactly one valid planar face, saying what and where. Construction
/// points and curves beside the face are reported as warnings.
/// OpenCASCADE's readers can crash on malformed files: call it through base/child_process.
CadFace load_face(const std::string& bytes, const std::string& name, const LoadOptions& options, Report& report);

/// load_face in a child process (base/child_process), whose crash becomes a FormatError. What tools call.
CadFace load_face_guarded(const std::string& bytes, const std::string& name, const LoadOptions& options,
                          Report& report);

}  // namespace quadrille::cad
