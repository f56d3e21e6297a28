#pragma once
// The harmonic function that carries the jump of the data at one corner, theta_c(x) = Arg((x - c) / (x - p_c)) with the
// corner c (`apex`) and a pole p_c outside the domain; field/corner_lifting.hpp makes liftings.

#include "model/field.hpp"

namespace quadrille::field {

/// theta_c at x; x must not be c.
double lifting_angle(const Lifting& lifting, Vec2 x);
/// Its gradient.
Vec2 lifting_gradient(const Lifting& lifting, Vec2 x);
/// The limit of theta_c when x -> c along the unit direction d, which points into the closed domain.
double lifting_angle_at_apex(const Lifting& lifting, Vec2 d);

}  // namespace quadrille::field
