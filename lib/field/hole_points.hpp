#pragma once
// One point inside each hole, where arg(z - h_j) is centred (lib/method.md §8.3).

#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::field {

/// For each hole (loops 1, 2, ...) its centroid, or where that is outside or much nearer to the boundary than others,
/// the middle of that chord across the hole which has the most room. Moves with the face, does not depend on where its
/// curves begin as long as the centroid serves.
std::vector<Vec2> hole_points(const CadFace& face);

}  // namespace quadrille::field
