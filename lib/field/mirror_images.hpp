#pragma once
// Images of a point in the boundary curves near it. arg(z - a) + arg(z - a*) is constant along a straight line, and
// along a circle but for arg of the point itself, when a* is the mirror image of a in it. Taking the images out of the
// data of a phase leaves them smooth however near a is to the boundary, where no mesh could follow them. Any point
// outside the domain would be as right: only accuracy depends on the choice.

#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::field {

struct MirrorImage {
  Vec2 position;  ///< outside the domain
  int loop = 0;   ///< beyond the outline (0), or inside this hole
};

/// Images of x, inside the domain, by inversion in the circles of curvature at its feet on the curves: at most one for
/// each curve, as far as feet are within a quarter of the diameter and three times the distance of the nearest one,
/// and where the node is not far off a small bend, and the image has room outside the domain, to all sides.
std::vector<MirrorImage> mirror_images(const CadFace& face, Vec2 x);

}  // namespace quadrille::field
