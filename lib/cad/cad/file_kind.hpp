#pragma once
// What the content of a CAD file says before a kernel reads it: its format, and errors. No OpenCASCADE types.

#include <string>

namespace quadrille::cad {

enum class CadFormat { step, iges, brep };

/// "STEP", "IGES", "BREP".
std::string format_name(CadFormat format);

/// "step", "iges", "brep": in names of programs and in digests of files.
std::string format_stem(CadFormat format);

/// Throws FormatError if `bytes` is empty, has none of the formats, is cut off before its end mark, or if the extension
/// of `name` belongs to another format. A name without extension (a pipe) is accepted.
CadFormat cad_format(const std::string& bytes, const std::string& name);

/// The first invalid reference between entities of a STEP file: to an entity that does not exist, or to one of a wrong
/// type ("#22 VERTEX_POINT refers to #23, which is of type DIRECTION, not CARTESIAN_POINT"). Empty if no such error is
/// found; types are checked only for the entities that make up faces.
std::string step_fault(const std::string& bytes);

}  // namespace quadrille::cad
