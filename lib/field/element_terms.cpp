#include "field/element_terms.hpp"

#include <algorithm>
#include <cmath>

#include "field/lifting.hpp"
#include "field/phase_value.hpp"

namespace quadrille::field {
namespace {

constexpr Vec2 centroid{-1.0 / 3, -1.0 / 3};
constexpr double margin = 1.1;  // for the bulge of curved edges, and stages of steps that leave the element

AngleExpansion expansion_on(const spectral::TriMap& map) {
  const Vec2 centre = map.position(centroid);
  double radius = 0;
  for (const Vec2 xi : {Vec2{-1, -1}, Vec2{1, -1}, Vec2{-1, 1}, Vec2{0, -1}, Vec2{0, 0}, Vec2{-1, 0}})
    radius = std::max(radius, distance(centre, map.position(xi)));
  return {centre, margin * radius};
}

}  // namespace

ElementTerms::ElementTerms(const Field& field, const spectral::TriMap& map) : expansion_(expansion_on(map)) {
  const Vec2 centre = map.position(centroid);
  if (field.kind == FieldKind::phase)
    split_terms(field.phase.terms, centre);
  else
    split_liftings(field.liftings, centre);
}

// The principal value of theta_c jumps across the segment from the apex to the pole: it is the continuous sum of the
// expansion only if no point of that segment is near.
void ElementTerms::split_liftings(const std::vector<Lifting>& liftings, Vec2 centre) {
  for (const Lifting& lifting : liftings)
    if (expansion_.is_far(lifting.apex, lifting.pole)) {
      expansion_.add(lifting.apex, lifting.jump);
      expansion_.add(lifting.pole, -lifting.jump);
      at_centre_ += lifting.jump * lifting_angle(lifting, centre);
    } else {
      near_liftings_.push_back(lifting);
    }
}

void ElementTerms::split_turns(const std::vector<PhaseTurn>& turns, std::vector<PhaseTurn>& near,
                               std::vector<PhaseTurn>& far) {
  for (const PhaseTurn& turn : turns) {
    if (turn.turns == 0) continue;
    const bool is_far = expansion_.is_far(turn.position, turn.position);
    (is_far ? far : near).push_back(turn);
    if (is_far) expansion_.add(turn.position, {static_cast<double>(turn.turns), 0});
  }
}

void ElementTerms::split_terms(const PhaseTerms& terms, Vec2 centre) {
  PhaseTerms far;
  split_turns(terms.nodes, near_terms_.nodes, far.nodes);
  split_turns(terms.holes, near_terms_.holes, far.holes);
  split_turns(terms.images, near_terms_.images, far.images);
  for (const CornerAngle& corner : terms.corner_angles)
    if (expansion_.is_far(corner.apex, corner.pole)) {
      expansion_.add(corner.apex, {corner.beta, 0});
      expansion_.add(corner.pole, {-corner.beta, 0});
      far.corner_angles.push_back(corner);
    } else {
      near_terms_.corner_angles.push_back(corner);
    }
  at_centre_ = explicit_direction(far, centre, centre);
}

}  // namespace quadrille::field
