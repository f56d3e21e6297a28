#pragma once
// Directions to align crosses with: points, curves and boxes, or a metric (formats/alignment.md).

#include "io/whole_file.hpp"
#include "model/given_metric.hpp"

namespace quadrille::io {

/// Positions as they are in the file, angles in radians, widths 0 of features without one. Throws FormatError, with the
/// position in the file, for anything that is no alignment.
GivenAlignment read_alignment(const InputFile& file);

/// The lengths of a table alone, in the same way; directions without lengths are refused.
GivenMetric read_metric(const InputFile& file);

}  // namespace quadrille::io
