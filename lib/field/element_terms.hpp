#pragma once
// The explicit terms of a field (liftings, or those of a phase) for evaluation on one element: most apexes, nodes and
// holes are far from it, and the sum of their angles is one power series there (base/angle_expansion).

#include <vector>

#include "base/angle_expansion.hpp"
#include "model/field.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::field {

class ElementTerms {
 public:
  ElementTerms(const Field& field, const spectral::TriMap& map);

  /// Whether far_liftings and far_phase are valid at x: in a disc that contains the element.
  bool contains(Vec2 x) const { return expansion_.contains(x); }

  /// Liftings that are not far, and the sum of the others at x.
  const std::vector<Lifting>& near_liftings() const { return near_liftings_; }
  Vec2 far_liftings(Vec2 x) const { return at_centre_ + expansion_.at(x); }

  /// Terms of a phase that are not far. The others sum up to the angle of far_direction() plus far_phase(x), radians.
  const PhaseTerms& near_terms() const { return near_terms_; }
  Vec2 far_direction() const { return at_centre_; }
  double far_phase(Vec2 x) const { return expansion_.at(x).x; }

 private:
  void split_liftings(const std::vector<Lifting>& liftings, Vec2 centre);
  void split_terms(const PhaseTerms& terms, Vec2 centre);
  void split_turns(const std::vector<PhaseTurn>& turns, std::vector<PhaseTurn>& near, std::vector<PhaseTurn>& far);

  AngleExpansion expansion_;
  Vec2 at_centre_;  // sum of the far liftings, or direction of the far terms, at the centre of the disc
  std::vector<Lifting> near_liftings_;
  PhaseTerms near_terms_;
};

}  // namespace quadrille::field
