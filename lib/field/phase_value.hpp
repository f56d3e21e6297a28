#pragma once
// Value and gradient of the explicit part of a phase (model/phase_terms.hpp; lib/method.md §8.3 and §8.4).

#include "base/vec2.hpp"
#include "model/phase_terms.hpp"

namespace quadrille::field {

/// theta_c at x; at the apex, or within rounding of it, its limit along `inward`, a unit vector into the closed domain.
double corner_angle(const CornerAngle& corner, Vec2 x, Vec2 inward);

/// The explicit part at x: continuous but for multiples of 2 pi. x must be none of the nodes; `inward` is used only
/// where x is an apex. Linear in the number of terms.
double explicit_phase(const PhaseTerms& terms, Vec2 x, Vec2 inward = {});

/// e^(i phi) of the explicit part, as a product of complex numbers without an angle but for the corners: many times
/// quicker where there are many holes. `towards`: a point of the domain, in whose direction limits at apexes are taken.
Vec2 explicit_direction(const PhaseTerms& terms, Vec2 x, Vec2 towards);

/// Its gradient: d left_of(z - a) / |z - a|^2 and the like. Not at nodes and apexes.
Vec2 explicit_phase_gradient(const PhaseTerms& terms, Vec2 x);

}  // namespace quadrille::field
