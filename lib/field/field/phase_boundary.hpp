#pragma once
// Boundary data of a phase with prescribed irregular nodes and corner valences (lib/method.md §8.1 to §8.5).
//
//   Phi: 4 theta_t along smooth pieces, theta_t the tangent angle, continuous along the loop; at corner c it jumps by
//        delta_c = 2 pi V_c - 4 omega_c from the incoming to the outgoing side (point 2).
//   g = Phi - sum d_k arg(z - a_k) - sum D_j arg(z - h_j) - sum beta_c theta_c (minus the terms of the images),
//       each arg continued along the loop: single-valued and continuous on each loop (point 5). On each loop Phi starts
//       with 4 theta_t in (-4 pi, 4 pi] and the args with their principal values: the data of a hole are determined
//       only up to 2 pi m_j.
//
// The angles along a loop, of the tangent and of the vectors from fixed centres to the point of the loop, are followed
// on pieces of the curves on which each provably differs by less than a quarter turn from a reference, so that no turn
// is missed, however near a centre is to the boundary.

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/angle.hpp"
#include "field/boundary_values.hpp"
#include "field/explicit_terms.hpp"
#include "model/cad_face.hpp"
#include "model/phase_nodes.hpp"

namespace quadrille::field {

/// `angle` plus the multiple of 2 pi that brings it nearest to `reference`.
inline double nearest_branch(double reference, double angle) { return reference + wrap_pi(angle - reference); }

/// Angles at a point of a loop, radians, each continuous along the loop except for the jumps of the tangent at corners.
struct LoopAngles {
  double tangent = 0;
  int corner_index = 0;         ///< sum (2 - V_c) over the corners passed: Phi = 4 tangent - 2 pi corner_index
  std::vector<double> centres;  ///< arg(x - c) for each centre c
};

/// The part [t0, t1] of a curve, with references: on this part each angle is the branch nearest to its reference.
struct AnglePiece {
  double t0 = 0, t1 = 0;
  LoopAngles reference;
  std::vector<Vec2> axes;  ///< for each centre, the vector whose angle is its reference

  /// For each point x, the sum of turns times the angle at x, over the centres. `sums` has as many entries as `x`.
  void sums_of_turns(const std::vector<TurnCentre>& centres, std::span<const Vec2> x, double* sums) const;
};

/// The angles at the start of a loop: principal values.
LoopAngles angles_at_start(const CadFace& face, const std::vector<TurnCentre>& centres, int loop);

/// Follows `angles` along [t0, t1] of `curve` to its end and appends the pieces. Throws ComputeError if the boundary
/// has a cusp or a centre lies on it.
void follow_angles(const CadFace& face, const std::vector<TurnCentre>& centres, int curve, double t0, double t1,
                   LoopAngles& angles, std::vector<AnglePiece>& pieces);

/// The piece of a curve that contains parameter t; where two pieces meet, the later one, or the earlier one if
/// `from_left`.
const AnglePiece& piece_at(const std::vector<AnglePiece>& pieces, double t, bool from_left);

/// The whole number of turns nearest to `angle`.
int round_to_turns(double angle);

/// By how much g and half of the explicit part A change across an apex, from the incoming to the outgoing side: the
/// energy needs it (galerkin/phase_energy.hpp).
struct ApexTurn {
  Vec2 position;
  double turn = 0;  ///< radians
};

class PhaseBoundary {
 public:
  /// Throws ComputeError for an impossible index sum, for nodes that are not inside the domain, for a boundary with a
  /// cusp, and for joints or curves that do not exist or are listed twice. `face` must outlive this object.
  PhaseBoundary(const CadFace& face, const PhaseNodes& prescribed);
  /// The same with corners that fit the nodes (SharedCorners::fit).
  PhaseBoundary(const CadFace& face, const PhaseNodes& prescribed, std::shared_ptr<SharedCorners> corners);
  /// The same on a mesh, with bridges over the jumps of g at enclosed joints. `mesh` must outlive this object.
  PhaseBoundary(const TriMesh& mesh, const PhaseNodes& prescribed, std::shared_ptr<SharedCorners> corners);

  const PhaseTerms& terms() const { return explicit_.terms; }
  /// At the apexes where g or a term of the explicit part jumps.
  std::vector<ApexTurn> apex_turns() const;
  /// Phi at t, radians; at the start of a curve the value of the outgoing side of the joint, at its end the value of
  /// the incoming side.
  double phase(int curve, double t) const;
  /// g at t, radians: the boundary data of s. Equal at the end of a curve and at the start of its successor.
  double remainder(int curve, double t) const;
  /// g at ascending parameters of one curve: faster than one at a time. `values` has as many entries as `t`.
  void remainders(int curve, std::span<const double> t, double* values) const;

 private:
  void follow_loop(int loop);
  void pass_apex(int loop, int apex, LoopAngles& angles);
  const BoundaryApexes& apexes() const { return corners_->terms().apexes; }
  void bridge(int curve, std::span<const double> t, double* values) const;
  double data(int loop, Vec2 x, const LoopAngles& angles, double corner_angles) const;
  void require_inside(int loop, const LoopAngles& start, const LoopAngles& end) const;
  void require_closure(int loop, const LoopAngles& start, const LoopAngles& end) const;

  const CadFace* face_;
  std::shared_ptr<SharedCorners> corners_;
  ExplicitTerms explicit_;
  std::vector<LoopCentres> loops_;
  std::vector<double> apex_remainders_;  ///< g at each apex; where it jumps (enclosed), the mean
  std::vector<double> apex_jumps_;       ///< of g at each apex, outgoing minus incoming side; 0 but at enclosed ones
  std::optional<CornerBridges> bridges_;
  std::vector<std::vector<AnglePiece>> pieces_;  ///< by curve, ascending t
};

}  // namespace quadrille::field
