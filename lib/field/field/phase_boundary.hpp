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
// See field/boundary_apexes for apexes and their valences, field/corner_terms and field/explicit_terms for the explicit
// terms, and field/followed_angles for the continuous angles.

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "field/boundary_values.hpp"
#include "field/corner_terms.hpp"
#include "field/explicit_terms.hpp"
#include "field/followed_angles.hpp"
#include "model/cad_face.hpp"
#include "model/phase_nodes.hpp"

namespace quadrille::field {

class PhaseBoundary {
 public:
  /// Throws ComputeError for an impossible index sum, for nodes that are not inside the domain, for a boundary with a
  /// cusp, and for joints or curves that do not exist or are listed twice. `face` must outlive this object.
  PhaseBoundary(const CadFace& face, const PhaseNodes& prescribed);
  /// The same with corners that fit the nodes (SharedCorners::fit).
  PhaseBoundary(const CadFace& face, const PhaseNodes& prescribed, std::shared_ptr<SharedCorners> corners);
  /// The same on a mesh, with bridges over the jumps of g at slits. `mesh` must outlive this object.
  PhaseBoundary(const TriMesh& mesh, const PhaseNodes& prescribed, std::shared_ptr<SharedCorners> corners);

  const PhaseTerms& terms() const { return explicit_.terms; }
  /// Interior angle omega_c, radians, for each of terms().corner_angles.
  std::vector<double> interior_angles() const;
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
  std::vector<double> apex_remainders_;  ///< g at each apex; where it jumps (at slits), the mean
  std::vector<double> apex_jumps_;       ///< of g at each apex, outgoing minus incoming side; 0 but at slits
  std::optional<CornerBridges> bridges_;
  std::vector<std::vector<AnglePiece>> pieces_;  ///< by curve, ascending t
};

}  // namespace quadrille::field
