#pragma once
// Joints of curves with different names inside the side of a block.

#include <vector>

#include "curve/chain.hpp"
#include "model/cad_face.hpp"

namespace quadrille::sizing {

/// Fractions of the chain's joints, ascending, between curves of different names of which at least one was given: no
/// edge of an element may belong to both curves. Default names made from numbers do not count. All pieces of the chain
/// must be CAD curves.
std::vector<double> name_joints(const curve::Chain& chain, const CadFace& face);

}  // namespace quadrille::sizing
