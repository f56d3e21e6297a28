#pragma once
// The mean width of a face.

#include "model/cad_face.hpp"

namespace quadrille::curve {

/// Twice the area over the length of the boundary: the width of a long strip.
double mean_width(const CadFace& face);

}  // namespace quadrille::curve
