#pragma once
// The explicit terms of a phase with prescribed nodes (model/phase_nodes.hpp): turns about the nodes, about one point
// and the foci of each hole, and about the mirror images of the nodes; and a multiple of theta_c for each corner. One
// object serves all sets of nodes with the same valences on the boundary for what does not depend on the nodes inside
// the domain: apexes, corner angles, and the turns about the holes.

#include <map>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/angle_sum.hpp"
#include "field/turn_centres.hpp"
#include "model/cad_face.hpp"
#include "model/phase_nodes.hpp"

namespace quadrille::field {

/// A boundary point with a prescribed valence: a joint of the face, or a boundary node inside a curve (lib/method.md
/// §8.2, §8.8).
struct BoundaryApex {
  int curve = 0;              ///< the curve that begins at the joint, or the curve of the boundary node
  double t = 0;               ///< parameter on `curve`
  double interior_angle = 0;  ///< omega, radians, between the tangents of both sides; pi inside a smooth curve
  int valence = 2;            ///< V
  bool is_enclosed = false;   ///< enclosed_joints(): the jump of the data is bridged, not carried by an angle term
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

struct CornerTerms {
  BoundaryApexes apexes;
  std::vector<HoleFocus> foci;
  std::vector<CornerAngle> corner_angles;
  std::vector<int> apex2corner_angle;  ///< position in corner_angles; -1 if the data do not jump at the apex
  std::vector<PhaseTurn> holes;        ///< h_j and the turns D_j that make the data of hole j single-valued
};

/// Throws as boundary_apexes().
CornerTerms corner_terms(const CadFace& face, const PhaseNodes& prescribed);

/// The sum of beta_c theta_c at x. If x is the apex of corner angle `at_apex` (-1: x is no such apex), its limit along
/// the unit vector `inward`.
double sum_of_corner_angles(const std::vector<CornerAngle>& corner_angles, Vec2 x, int at_apex, Vec2 inward);

/// What the data at parameters `t` of a curve need that does not depend on the nodes inside the domain.
struct BoundarySamples {
  std::vector<double> t;
  std::vector<int> apexes;             ///< the apex at the point; -1: none
  std::vector<Vec2> x;                 ///< the points
  std::vector<double> tangent_angles;  ///< on the side of rising t, principal values
  std::vector<double> corner_angles;   ///< the sums of beta_c theta_c; 0 at apexes
};

/// Corner terms, the samples of the boundary asked for so far, and the images of nodes. Not to be used by two threads
/// at once.
class SharedCorners {
 public:
  /// Throws as corner_terms(). `face` must outlive this object.
  SharedCorners(const CadFace& face, const PhaseNodes& prescribed);
  /// Whether `prescribed` has the valences on the boundary for which this was made.
  bool fit(const PhaseNodes& prescribed) const;
  const CornerTerms& terms() const { return terms_; }
  /// TurnCentre::extent of h_j, j = `loop`: that of a slit is a joint.
  double extent_of_centre(int loop) const;
  /// Valid until the next call. `t` is not empty.
  const BoundarySamples& samples(int curve, std::span<const double> t);
  /// The mirror images of a node at x.
  const std::vector<MirrorImage>& images(Vec2 x);

 private:
  std::vector<CornerValence> corners_;
  std::vector<BoundaryNode> boundary_nodes_;
  const CadFace* face_;
  MirrorImages mirror_images_;
  CornerTerms terms_;
  std::vector<std::unordered_map<double, BoundarySamples>> samples_;  ///< by curve, then first parameter
  std::map<std::pair<double, double>, std::vector<MirrorImage>> images_;
};

/// The centre of the term turns * arg(z - position).
struct TurnCentre {
  Vec2 position;
  int turns = 0;
  int loop = -1;      ///< -1: an irregular node, inside the domain; 0: outside the outline; j: inside hole j
  double extent = 0;  ///< points nearer than this are the centre itself, a joint of the slit `loop`; 0: not on a curve

  /// The required winding number of a loop of the face around `position`: 1 of the outline (counter-clockwise) around
  /// all that it encloses, -1 of a hole (clockwise) around the points inside it, 0 otherwise.
  int winding_number(int of_loop) const { return of_loop == 0 ? (loop == 0 ? 0 : 1) : (loop == of_loop ? -1 : 0); }

  bool is_at(Vec2 x) const { return distance(x, position) < extent; }
  /// The vector from the centre to a point of a curve; if that is the centre itself, `away`, the direction in which the
  /// curve leaves it.
  Vec2 to(Vec2 x, Vec2 away) const { return is_at(x) ? away : x - position; }
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
