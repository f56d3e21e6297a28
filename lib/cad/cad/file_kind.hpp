#pragma once
// Determines the CAD format of a file from its content; the extension must not contradict it.

#include <string>

namespace quadrille::cad {

enum class CadFormat { step, iges, brep };

/// "STEP", "IGES", "BREP".
std::string format_name(CadFormat format);

/// Throws FormatError if `bytes` is empty, has none of the formats, is cut off before its end mark, or if the extension
/// of `name` belongs to another format. A name without extension (a pipe) is accepted.
CadFormat cad_format(const std::string& bytes, const std::string& name);

}  // namespace quadrille::cad
