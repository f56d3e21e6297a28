#pragma once
// The explicit terms of a phase with prescribed nodes (model/phase_terms.hpp): turns about the nodes, about one point
// and the foci of each hole, and about the mirror images of the nodes; and a multiple of theta_c for each corner.

#include <vector>

#include "field/corner_terms.hpp"
#include "model/cad_face.hpp"
#include "model/phase_nodes.hpp"
#include "model/phase_terms.hpp"

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

/// The terms for prescribed nodes, beside those of the corners. The turns D_j of each hole make its data single-valued.
ExplicitTerms explicit_terms(SharedCorners& corners, const std::vector<PhaseNode>& nodes);

}  // namespace quadrille::field
