#pragma once
// Boundary data of a phase with prescribed irregular nodes and corner valences (lib/method.md §8.1 to §8.5).
//
//   Phi: 4 theta_t along smooth pieces, theta_t the tangent's angle followed along the loop; at corner c it jumps by
//        delta_c = 2 pi V_c - 4 omega_c from the incoming to the outgoing side (point 2).
//   g = Phi - sum d_k arg(z - a_k) - sum D_j arg(z - h_j) - sum beta_c theta_c (less the images' terms), all followed
//   along the loop: single-valued
//       and continuous on each loop (point 5). On each loop Phi begins with 4 theta_t in (-4 pi, 4 pi], the args with
//       their principal values: data of a hole are free up to 2 pi m_j anyway.
//
// Apexes and their valences are in field/boundary_apexes, the explicit terms in field/explicit_terms, the angles that
// are followed in field/followed_angles.

#include <vector>

#include "field/boundary_apexes.hpp"
#include "field/explicit_terms.hpp"
#include "field/followed_angles.hpp"
#include "model/cad_face.hpp"
#include "model/phase_nodes.hpp"
#include "model/phase_terms.hpp"

namespace quadrille::field {

class PhaseBoundary {
 public:
  /// Throws ComputeError for an impossible index sum, for nodes that are not inside the domain, for a boundary with a
  /// cusp, and for joints or curves that do not exist or are listed twice. `face` must outlive this.
  PhaseBoundary(const CadFace& face, const PhaseNodes& prescribed);

  const PhaseTerms& terms() const { return explicit_.terms; }
  /// omega_c of each of terms().corner_angles.
  std::vector<double> interior_angles() const;
  /// Phi at t; at corners the value of the outgoing side, at a curve's end the value of the incoming one.
  double phase(int curve, double t) const;
  /// g at t: the data of s. The same number at the end of a curve and at the start of its successor.
  double remainder(int curve, double t) const;

 private:
  void follow_loop(int loop);
  void pass_apex(int apex, LoopAngles& angles);
  double data(const LoopAngles& angles, double corner_angles) const;
  void require_inside(int loop, const LoopAngles& start, const LoopAngles& end) const;
  void require_closure(int loop, const LoopAngles& start, const LoopAngles& end) const;

  const CadFace* face_;
  BoundaryApexes apexes_;
  ExplicitTerms explicit_;
  std::vector<double> apex_remainders_;          ///< g at each apex
  std::vector<std::vector<AnglePiece>> pieces_;  ///< by curve, ascending
};

}  // namespace quadrille::field
