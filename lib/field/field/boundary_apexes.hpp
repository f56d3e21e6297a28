#pragma once
// Apexes of the boundary with their prescribed valences: every joint of the face, and the boundary nodes inside curves
// (lib/method.md §8.2, §8.8).

#include <vector>

#include "model/cad_face.hpp"
#include "model/phase_nodes.hpp"

namespace quadrille::field {

/// A boundary point with a prescribed valence.
struct BoundaryApex {
  int curve = 0;              ///< the curve that begins at the joint, or the curve of the boundary node
  double t = 0;               ///< parameter on `curve`
  double interior_angle = 0;  ///< omega, radians, between the tangents of both sides; pi inside a smooth curve
  int valence = 2;            ///< V
};

struct BoundaryApexes {
  std::vector<BoundaryApex> apexes;  ///< sorted by curve, then t
  std::vector<int> offsets;          ///< apexes of curve c: [offsets[c], offsets[c + 1]), its joint first
};

/// Checks sum (4 - V_k) + sum (2 - V_c) = 4 chi (lib/method.md §8.1); throws ComputeError with the sums otherwise.
void require_valence_sum(const CadFace& face, const PhaseNodes& prescribed);

/// Unlisted joints have valence 2; a boundary node at the end of a curve is the joint there. Throws ComputeError if a
/// joint, curve or parameter does not exist, a joint is listed twice, or boundary nodes coincide.
BoundaryApexes boundary_apexes(const CadFace& face, const PhaseNodes& prescribed);

/// The position in `apexes` of the apex at parameter t of `curve`, up to round-off; -1 if no apex lies there.
int find_apex(const CadFace& face, const BoundaryApexes& apexes, int curve, double t);

/// Unit tangents at an apex: of the incoming and of the outgoing side of the boundary.
struct ApexTangents {
  Vec2 in, out;
};
/// The tangents at an apex; at a joint, those of the two curves that meet there.
ApexTangents tangents_at(const CadFace& face, const BoundaryApex& apex);

}  // namespace quadrille::field
