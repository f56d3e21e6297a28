#pragma once
// Which explicit terms a phase with prescribed nodes has (model/phase_terms.hpp): turns about the nodes, about a point
// and the foci of each hole and about the nodes' mirror images, and a multiple of an angle for each corner.

#include <vector>

#include "field/boundary_apexes.hpp"
#include "model/cad_face.hpp"
#include "model/phase_nodes.hpp"
#include "model/phase_terms.hpp"

namespace quadrille::field {

/// The centre of the term turns * arg(z - position).
struct TurnCentre {
  Vec2 position;
  int turns = 0;
  int loop = -1;  ///< -1: an irregular node, inside the domain; 0: beyond the outline; j: inside hole j

  /// How often a loop of the face must wind round `position`: the outline (counter-clockwise) once round all that it
  /// encloses, a hole (clockwise) once, with sign -1, round what lies inside it.
  int winding_number(int of_loop) const { return of_loop == 0 ? (loop == 0 ? 0 : 1) : (loop == of_loop ? -1 : 0); }
};

struct ExplicitTerms {
  PhaseTerms terms;
  std::vector<TurnCentre> centres;     ///< of terms.nodes, then terms.holes, then terms.images
  std::vector<int> apex2corner_angle;  ///< index into terms.corner_angles, -1 for an apex where the data do not jump
};

ExplicitTerms explicit_terms(const CadFace& face, const BoundaryApexes& apexes, const std::vector<PhaseNode>& nodes);

}  // namespace quadrille::field
