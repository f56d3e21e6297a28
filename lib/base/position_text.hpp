#pragma once
// How messages write a position.

#include <string>

#include "base/vec2.hpp"

namespace quadrille {

/// "(x, y)" with six digits each. Give it positions in the coordinates of the CAD file: x + face.origin.
std::string position_text(Vec2 x);

}  // namespace quadrille
