#include "field/phase_value.hpp"

#include <cmath>
#include <cstdlib>

#include "field/lifting.hpp"

namespace quadrille::field {

namespace {

// A point nearer to an apex than this, relative to |c - p_c|, is treated as the apex: the direction to it is noise.
constexpr double apex_tol = 1e-13;

Lifting lifting(const CornerAngle& corner) { return {-1, corner.apex, corner.pole, {}}; }

bool is_apex(const CornerAngle& corner, Vec2 x) {
  return norm2(x - corner.apex) <= apex_tol * apex_tol * norm2(corner.pole - corner.apex);
}

double sum_of_turns(const std::vector<PhaseTurn>& turns, Vec2 x) {
  double sum = 0;
  for (const PhaseTurn& turn : turns) {
    if (turn.turns != 0) sum += turn.turns * angle_of(x - turn.position);
  }
  return sum;
}

// z times (x - a)^d for each turn. The result is not normalised; it is rescaled only to avoid overflow and underflow.
Vec2 turned(Vec2 z, const std::vector<PhaseTurn>& turns, Vec2 x) {
  for (const PhaseTurn& turn : turns) {
    const Vec2 r = x - turn.position;
    if (r == Vec2{}) continue;
    const Vec2 factor = turn.turns > 0 ? r : Vec2{r.x, -r.y};
    for (int i = std::abs(turn.turns); i > 0; --i) {
      z = product(z, factor);
      const double size = std::abs(z.x) + std::abs(z.y);
      if (size < 1e-50 || size > 1e50) z = z / size;
    }
  }
  return z;
}

Vec2 gradient_of_turns(const std::vector<PhaseTurn>& turns, Vec2 x) {
  Vec2 sum;
  for (const PhaseTurn& turn : turns) {
    const Vec2 r = x - turn.position;
    if (turn.turns != 0) sum += turn.turns * left_of(r) / norm2(r);
  }
  return sum;
}

}  // namespace

double corner_angle(const CornerAngle& corner, Vec2 x, Vec2 inward) {
  return is_apex(corner, x) ? lifting_angle_at_apex(lifting(corner), inward) : lifting_angle(lifting(corner), x);
}

double explicit_phase(const PhaseTerms& terms, Vec2 x, Vec2 inward) {
  double phase = sum_of_turns(terms.nodes, x) + sum_of_turns(terms.holes, x) + sum_of_turns(terms.images, x);
  for (const CornerAngle& corner : terms.corner_angles) phase += corner.beta * corner_angle(corner, x, inward);
  return phase;
}

Vec2 explicit_direction(const PhaseTerms& terms, Vec2 x, Vec2 towards, double remainder) {
  double angle = remainder;
  for (const CornerAngle& corner : terms.corner_angles) {
    const Vec2 inward = is_apex(corner, x) ? normalized(towards - x) : Vec2{};
    angle += corner.beta * corner_angle(corner, x, inward);
  }
  const Vec2 z = turned(turned(turned(unit(angle), terms.nodes, x), terms.holes, x), terms.images, x);
  return normalized(z);
}

Vec2 explicit_phase_gradient(const PhaseTerms& terms, Vec2 x) {
  Vec2 gradient =
      gradient_of_turns(terms.nodes, x) + gradient_of_turns(terms.holes, x) + gradient_of_turns(terms.images, x);
  for (const CornerAngle& corner : terms.corner_angles) gradient += corner.beta * lifting_gradient(lifting(corner), x);
  return gradient;
}

}  // namespace quadrille::field
