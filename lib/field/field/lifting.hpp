#pragma once
// The harmonic function that represents the jump of the data at one corner: theta_c(x) = Arg((x - c) / (x - p_c)),
// radians, with the corner c (`apex`) and a pole p_c outside the domain. Liftings are constructed in
// field/corner_lifting.hpp.

#include "model/field.hpp"

namespace quadrille::field {

/// theta_c at x; x must not be c.
double lifting_angle(const Lifting& lifting, Vec2 x);
/// Its gradient.
Vec2 lifting_gradient(const Lifting& lifting, Vec2 x);
/// The limit of theta_c as x -> c along the unit vector d, which points from c into the closed domain.
double lifting_angle_at_apex(const Lifting& lifting, Vec2 d);

}  // namespace quadrille::field
