#pragma once
// Boundary data of a phase with irregular nodes and corner valences as asked (lib/method.md §8.1 to §8.5).
//
//   Phi: 4 theta_t along smooth pieces, theta_t the tangent's angle followed along the loop; at corner c it jumps by
//        delta_c = 2 pi V_c - 4 omega_c from the incoming to the outgoing side (point 2).
//   g = Phi - sum d_k arg(z - a_k) - sum D_j arg(z - h_j) - sum beta_c theta_c (less the images' terms), all followed
//   along the loop: single-valued
//       and continuous on each loop (point 5). On each loop Phi begins with 4 theta_t in (-4 pi, 4 pi], the args with
//       their principal values: data of a hole are free up to 2 pi m_j anyway.

#include <vector>

#include "field/hole_foci.hpp"
#include "field/mirror_images.hpp"
#include "model/cad_face.hpp"
#include "model/phase_nodes.hpp"
#include "model/phase_terms.hpp"

namespace quadrille::field {

/// Throws ComputeError with the arithmetic unless sum (4 - V_k) + sum (2 - V_c) = 4 chi (point 1).
void require_index_sum(const CadFace& face, const PhaseNodes& asked);

class PhaseBoundary {
 public:
  /// Every angle is followed over pieces so short that it provably turns by less than a quarter turn to either side.
  /// Throws ComputeError for an impossible index sum, for nodes that are not inside the domain, and for joints or
  /// curves that do not exist or are listed twice. `face` must outlive this.
  PhaseBoundary(const CadFace& face, const PhaseNodes& asked);

  const PhaseTerms& terms() const { return terms_; }
  /// omega_c of each of terms().corner_angles.
  std::vector<double> interior_angles() const;
  /// Phi at t; at corners the value of the outgoing side, at a curve's end that of the incoming one.
  double phase(int curve, double t) const;
  /// g at t: the data of s. The same number at the end of a curve and at the start of its successor.
  double remainder(int curve, double t) const;

 private:
  /// A joint, or a boundary node inside a curve.
  struct Apex {
    int curve = 0;
    double t = 0;
    double angle = 0;  ///< omega
    int valence = 2;
    int term = -1;         ///< index into corner_angles, -1: it has none
    double remainder = 0;  ///< g there
  };
  /// A part of a curve with the references from which angles differ by less than a quarter turn on it.
  struct Piece {
    double t0 = 0, t1 = 0;
    double tangent_angle = 0;         ///< followed along the loop
    int corner_index = 0;             ///< sum (2 - V_c) over the corners passed: Phi = 4 theta_t - 2 pi corner_index
    std::vector<double> turn_angles;  ///< of nodes, holes, images, followed along the loop
  };
  /// The angles at the front of the walk along a loop.
  struct Walk;

  void make_apexes(const PhaseNodes& asked);
  void make_corner_angle(Apex& apex, Vec2 tangent_in, Vec2 tangent_out);
  void make_turns(const PhaseNodes& asked);
  void walk_loop(int loop);
  void pass_apex(Apex& apex, Walk& walk);
  void walk_curve(int curve, double t0, double t1, Walk& walk);
  void walk_piece(const Nurbs& piece, int curve, Walk& walk);
  void require_inside(int loop, const Walk& start, const Walk& end) const;
  void require_closure(int loop, const Walk& start, const Walk& end) const;
  int winding(int i, int loop) const;
  PhaseTurn& centre_of_turns(const MirrorImage& image);
  const PhaseTurn& turn(int i) const;
  int num_turns() const { return static_cast<int>(terms_.nodes.size() + terms_.holes.size() + terms_.images.size()); }
  bool is_monotone_piece(const Nurbs& piece) const;
  [[noreturn]] void refuse(const Nurbs& piece) const;
  double corner_angles(Vec2 x, int apex_term, Vec2 inward) const;
  const Piece& piece_at(int curve, double t, bool from_left) const;
  const Apex* apex_at(int curve, double t) const;

  const CadFace* face_;
  PhaseTerms terms_;
  std::vector<HoleFocus> foci_;
  std::vector<int> image_loops_;   ///< 0: beyond the outline, j: inside hole j
  std::vector<Apex> apexes_;       ///< sorted by curve, then t
  std::vector<int> apex_offsets_;  ///< curve c has apexes [apex_offsets_[c], apex_offsets_[c+1]), its joint first
  std::vector<std::vector<Piece>> pieces_;  ///< by curve, ascending
};

}  // namespace quadrille::field
