#pragma once
// Directions to align crosses with: points, curves and boxes, or a metric (formats/alignment.md).

#include "io/whole_file.hpp"
#include "model/given_metric.hpp"

namespace quadrille::io {

/// Positions become relative to `origin` (of the face; the file's include it), angles radians. `usual_width`: of
/// features without one. Throws FormatError, with the position in the file, for anything that is no alignment.
GivenAlignment read_alignment(const InputFile& file, Vec2 origin, double usual_width);

/// The lengths of a table alone, in the same way; directions without lengths are refused.
GivenMetric read_metric(const InputFile& file, Vec2 origin);

}  // namespace quadrille::io
