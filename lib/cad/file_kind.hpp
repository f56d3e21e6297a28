#pragma once
// Which CAD format a file holds: by its content; its extension may not contradict.

#include <string>

namespace quadrille::cad {

enum class CadFormat { step, iges, brep };

/// "STEP", "IGES", "BREP".
std::string format_name(CadFormat format);

/// Throws FormatError when `bytes` is empty, holds none of the formats, is cut off before its end mark, or when the
/// extension of `name` says something else. A name without extension (a pipe) says nothing.
CadFormat cad_format(const std::string& bytes, const std::string& name);

}  // namespace quadrille::cad
