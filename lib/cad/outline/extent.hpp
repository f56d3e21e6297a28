#pragma once
// Size of a loop of curves: enclosed area and diameter.

#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::outline {

/// The area enclosed by the closed chain of curves, positive if the chain is counter-clockwise.
double signed_area(const std::vector<Nurbs>& loop);
/// Of all loops of the face: without its holes.
double area(const CadFace& face);

/// The largest distance between two points of the curves: sampled, then refined on the curves, so that it is invariant
/// under rotation.
double diameter(const std::vector<Nurbs>& loop);

}  // namespace quadrille::outline
