#pragma once
// How a STEP file was made, where points2step or drawing2step made it: they write a provenance of one step
// (formats/README.md, "Provenance") into FILE_DESCRIPTION, behind the text "Quadrille provenance", in as many strings
// as it takes.

#include <string>
#include <string_view>

#include "model/provenance.hpp"

namespace quadrille::io {

/// Whether the command converts points or drawings to STEP files.
constexpr bool converts_shapes(std::string_view tool) { return tool == "points2step" || tool == "drawing2step"; }

/// Empty for other files, and for texts that are no such provenance.
Provenance step_origin(const std::string& bytes);

}  // namespace quadrille::io
