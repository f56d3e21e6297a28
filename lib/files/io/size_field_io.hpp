#pragma once
// Points and boxes, or a table of points, that prescribe a size of elements (formats/size-field.md).

#include "io/whole_file.hpp"
#include "model/size_sources.hpp"

namespace quadrille::io {

/// Positions as in the file: with two coordinates (x, y, 0), or with three. Throws FormatError, with the position in
/// the file, for anything that is no size field.
SizeSources read_size_field(const InputFile& file);

}  // namespace quadrille::io
