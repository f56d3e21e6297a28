#pragma once
// Exact harmonic liftings of tangent jumps (lib/method.md §3, §8.4).
//
// At a corner c the data jump from v_in (end of the incoming curve) to v_out (start of the outgoing one). The function
// jump * theta_c(x), theta_c = Arg((z - c)/(z - p_c)), is harmonic in the domain and has exactly that jump at c, so
// that what is left after subtracting it has continuous data.

#include <vector>

#include "model/cad_face.hpp"
#include "model/field.hpp"

namespace quadrille::field {

/// The point half the way from `start`, on the boundary, along the unit `direction` out of the domain to whatever
/// boundary the ray meets first, and no farther than the diameter.
Vec2 half_way(const CadFace& face, Vec2 start, Vec2 direction);

/// p_c for an apex on the boundary: half_way along the exterior bisector. `tangent_out`: the unit tangent of the
/// boundary as it leaves the apex; `interior_angle` in radians.
Vec2 exterior_pole(const CadFace& face, Vec2 apex, Vec2 tangent_out, double interior_angle);

/// One lifting for every joint whose data jump by more than round-off, with its exterior_pole.
std::vector<Lifting> corner_liftings(const CadFace& face);

}  // namespace quadrille::field
