#pragma once
// Periodic sides of a curved face: a rigid motion of space maps the one onto the other.

#include "cad/periodic_options.hpp"
#include "model/cad_face.hpp"

namespace quadrille::cad {

/// As pair_periodic_sides, of a face with a chart. The curve in space of the second side is replaced by the exact image
/// of the first one's; that in the chart stays where it is, with the parameters of the first one, mirrored: how the
/// chart maps both is of no concern, as lengths along them are those in space. The angle of the pair is that of the
/// rotation in space, its shift is 0: the motion is surface::periodic_motion.
void pair_sides_in_space(CadFace& face, const PeriodicRequest& request);

}  // namespace quadrille::cad
