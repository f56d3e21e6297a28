#pragma once
// Values and gradients of the parts of a field: the liftings of a harmonic field (field/boundary_values.hpp makes
// them), and the explicit terms and the remainder s of a phase (model/phase_nodes.hpp; lib/method.md §8.3 and §8.4).

#include "base/vec2.hpp"
#include "model/field.hpp"
#include "model/phase_nodes.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::field {

/// theta_c at x; x must not be c.
double lifting_angle(const Lifting& lifting, Vec2 x);
/// What liftings add to the field at x, which must not be an apex.
Vec2 lifting_sum(const std::vector<Lifting>& liftings, Vec2 x);
/// The gradient of theta_c.
Vec2 lifting_gradient(const Lifting& lifting, Vec2 x);
/// The limit of theta_c as x -> c along the unit vector d, which points from c into the closed domain.
double lifting_angle_at_apex(const Lifting& lifting, Vec2 d);

/// theta_c at x, radians; at the apex, or within round-off of it, its limit along `inward`, a unit vector into the
/// closed domain.
double corner_angle(const CornerAngle& corner, Vec2 x, Vec2 inward);

/// The explicit part at x, radians: continuous up to multiples of 2 pi. x must not be a node; `inward` is used only if
/// x is an apex. Cost: linear in the number of terms.
double explicit_phase(const PhaseTerms& terms, Vec2 x, Vec2 inward = {});

/// The product of two complex numbers, which adds their angles.
inline Vec2 product(Vec2 a, Vec2 b) { return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x}; }

/// e^(i phi) of the explicit part, as a product of complex numbers: angles are evaluated for corners only, which is
/// many times faster if there are many holes. `towards`: a point of the domain; limits at apexes are taken in its
/// direction. `remainder`, radians, is added to phi.
Vec2 explicit_direction(const PhaseTerms& terms, Vec2 x, Vec2 towards, double remainder = 0);

/// Gradient of the explicit part: sum of d left_of(z - a) / |z - a|^2 and the corner terms. Undefined at nodes and
/// apexes.
Vec2 explicit_phase_gradient(const PhaseTerms& terms, Vec2 x);

/// s and its gradient at a point of an element, and the map of the element there.
struct RemainderSample {
  Vec2 x;
  Mat2 dx_dxi;
  double value = 0;
  Vec2 slope;
};

/// `coefs`: of s, in the orthogonal basis.
RemainderSample remainder_sample(const spectral::TriMap& map, int order, const double* coefs, Vec2 xi);

}  // namespace quadrille::field
