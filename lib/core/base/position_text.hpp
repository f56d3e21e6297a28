#pragma once
// Text of a position in messages.

#include <string>

#include "base/vec2.hpp"

namespace quadrille {

/// "(x, y)" with six digits each. `x` must be in the coordinates of the CAD file: a position plus face.origin. If a
/// coordinate is no finite number, the text names an internal error instead: no message has "nan" for a place.
std::string position_text(Vec2 x);

/// position_text, where a coordinate that is only a rounding error relative to the other one is written as 0.
std::string rounded_position_text(Vec2 x);

}  // namespace quadrille
