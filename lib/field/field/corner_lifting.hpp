#pragma once
// Exact harmonic liftings of tangent jumps (lib/method.md §3, §8.4).
//
// At a corner c the data jump from v_in (end of the incoming curve) to v_out (start of the outgoing one). The function
// jump * theta_c(x), theta_c = Arg((z - c)/(z - p_c)), is harmonic in the domain and has exactly that jump at c: after
// subtracting it, the data are continuous at c.

#include <vector>

#include "model/cad_face.hpp"
#include "model/field.hpp"

namespace quadrille::field {

/// Smaller jumps of the data, of v or of the phase, are rounding of the decimals in the CAD file (a tangent jump of
/// 2.5e-11 radians). By the maximum principle the error of the field is no larger, and every lifting costs time at each
/// evaluation of the field.
inline constexpr double jump_tol = 1e-10;

/// The midpoint between `start`, a boundary point, and the first intersection of the boundary with the ray along the
/// unit vector `direction` out of the domain. The distance from `start` is at most the diameter.
Vec2 half_way(const CadFace& face, Vec2 start, Vec2 direction);

/// p_c for an apex on the boundary: half_way along the exterior bisector. `tangent_out`: unit tangent of the outgoing
/// side of the boundary at the apex; `interior_angle` in radians.
Vec2 exterior_pole(const CadFace& face, Vec2 apex, Vec2 tangent_out, double interior_angle);

/// The lifting at a joint where the function that it is made for jumps from `incoming` to `outgoing`; its pole is the
/// exterior_pole.
Lifting lifting_at(const CadFace& face, int joint, Vec2 incoming, Vec2 outgoing);

/// One lifting for every joint at which the data jump by more than round-off, except at slits: there is no place for
/// the pole, and other joints are in the same place (BoundaryValues bridges those jumps).
std::vector<Lifting> corner_liftings(const CadFace& face);

}  // namespace quadrille::field
