#pragma once
// A table of points with prescribed element sizes (formats/size-field.md, "As a table").

#include "io/input_file.hpp"
#include "model/size_sources.hpp"

namespace quadrille::io {

/// Whether the file is a table: neither JSON nor XML.
bool is_size_table(const InputFile& file);

/// The points, relative to `origin` (of the face; the file's include it). Throws FormatError with the line for anything
/// that is no table of x, y and size.
SizeSources read_size_table(const InputFile& file, Vec2 origin);

}  // namespace quadrille::io
