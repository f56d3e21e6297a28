#pragma once
// Curves that were drawn without a face: the wires that they make.

#include "heal/heal_scale.hpp"
#include "heal/raw_face.hpp"

namespace quadrille::heal {

/// Makes closed wires of the edges of all wires, which may have any order and direction: edges follow each other where
/// their ends, and no other, are within the tolerance, and are turned round where necessary. Each wire begins with its
/// first edge, in the direction of that. Throws FormatError, with the edge, the place, the size and a remedy, where the
/// curves leave a gap or more than two of them meet.
void close_wires(RawFace& raw, const HealScale& scale);

}  // namespace quadrille::heal
