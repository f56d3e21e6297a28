#pragma once
// The explicit terms of a phase with prescribed nodes (model/phase_nodes.hpp): turns about the nodes, about one point
// and the foci of each hole, and about the mirror images of the nodes; and a multiple of theta_c for each corner.

#include <vector>

#include "base/angle_sum.hpp"
#include "field/corner_terms.hpp"
#include "model/cad_face.hpp"
#include "model/phase_nodes.hpp"

namespace quadrille::field {

/// The centre of the term turns * arg(z - position).
struct TurnCentre {
  Vec2 position;
  int turns = 0;
  int loop = -1;  ///< -1: an irregular node, inside the domain; 0: outside the outline; j: inside hole j

  /// The required winding number of a loop of the face around `position`: 1 of the outline (counter-clockwise) around
  /// all that it encloses, -1 of a hole (clockwise) around the points inside it, 0 otherwise.
  int winding_number(int of_loop) const { return of_loop == 0 ? (loop == 0 ? 0 : 1) : (loop == of_loop ? -1 : 0); }
};

/// The terms and their centres.
struct ExplicitTerms {
  PhaseTerms terms;
  std::vector<TurnCentre> centres;  ///< of terms.nodes, then terms.holes, then terms.images
};

/// The centres as seen from one loop. Most are so far from a small hole that the sum of their terms is one power
/// series.
class LoopCentres {
 public:
  LoopCentres(const CadFace& face, int loop, const std::vector<TurnCentre>& centres);
  /// The centres that are near, or which the loop must enclose.
  const std::vector<TurnCentre>& followed() const { return followed_; }
  /// The sum of the terms of all others at a point of the loop: continuous along it, from the principal values at the
  /// start of the loop.
  double sum_of_far(Vec2 x) const { return constant_ + far_.at(x).x; }

 private:
  std::vector<TurnCentre> followed_;
  AngleExpansion far_;
  double constant_ = 0;
};

/// The terms for prescribed nodes, beside those of the corners. The turns D_j of each hole make its data single-valued.
ExplicitTerms explicit_terms(SharedCorners& corners, const std::vector<PhaseNode>& nodes);

}  // namespace quadrille::field
