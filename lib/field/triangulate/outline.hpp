#pragma once
// The boundary of a face as smooth pieces, and the geometry of the junctions between them.
//
// A piece is a part of one CAD curve without a joint or a knot of continuity below C3 inside. Junction i is the START
// of piece i. Pieces are ordered and directed along the loops as the curves are, with the face on the left.
//
// A slit is a curve that the face has on both sides (CadFace::partners): its pieces are there twice, in opposite
// directions. The first of two partners is the one with the lower number.

#include <vector>

#include "curve/chain.hpp"
#include "model/cad_face.hpp"

namespace quadrille::triangulate {

struct SmoothPiece {
  int curve = 0;
  double t0 = 0, t1 = 0;  ///< parameters on the curve
  double s0 = 0, s1 = 0;  ///< arc length on the curve
  bool is_straight = false;
  int previous = 0, next = 0;  ///< in the loop
  int partner = -1;            ///< the piece that runs along the other side of a slit, or -1

  double length() const { return s1 - s0; }
};

struct Junction {
  Vec2 position;
  int place = 0;  ///< lowest number of the junctions in this place: where slits end, or a region touches itself
  double interior_angle = 0;  ///< radians
  /// An enclosed joint, where the boundary data jump without a lifting (field/boundary_values.hpp).
  bool has_bridge = false;
  double curvature_in = 0, curvature_out = 0;              ///< of the pieces on both sides, 1 / length
  double curvature_slope_in = 0, curvature_slope_out = 0;  ///< d curvature / d arc length
};

/// t0, the knots of the curve between t0 and t1, and t1.
std::vector<double> span_ends(const Nurbs& curve, double t0, double t1);

class Outline {
 public:
  /// `face` must outlive the outline. A curve is straight if its poles deviate from its chord by less than
  /// `straight_tol` (a length).
  Outline(const CadFace& face, double straight_tol);

  const CadFace& face() const { return *face_; }
  const std::vector<SmoothPiece>& pieces() const { return pieces_; }
  const std::vector<Junction>& junctions() const { return junctions_; }
  const curve::ArcLength& arc_length(int curve) const { return lengths_[curve]; }
  /// The point of `curve` at parameter t.
  Vec2 at(int curve, double t) const;
  /// The parameter, on the partner of `curve`, of the point at parameter t.
  double partner_parameter(int curve, double t) const;
  /// Whether the piece is the second side of a slit.
  bool is_second_side(int piece) const { return pieces_[piece].partner >= 0 && pieces_[piece].partner < piece; }

 private:
  void add_pieces(int curve, double straight_tol);
  void link_loops();
  void link_slits();
  void link_places();
  Junction junction(int piece, const std::vector<bool>& are_enclosed) const;

  const CadFace* face_;
  std::vector<curve::ArcLength> lengths_;
  std::vector<SmoothPiece> pieces_;
  std::vector<Junction> junctions_;
};

/// The clearance of junctions: their distance to the parts of the boundary that do not start there.
class Clearance {
 public:
  /// Samples every piece such that its polyline turns by at most 10 degrees at a vertex.
  explicit Clearance(const Outline& outline);

  /// Distance from junction j to all pieces except those that end in its place (two, more at the end of a slit and
  /// where a region touches itself); of the two that meet at j, only the parts that approach the junction again count,
  /// and none of a piece that closes there. Infinite if there are no such parts.
  double at_junction(int j) const;

 private:
  bool ends_in(int piece, int place) const;
  bool is_closed(int piece) const;  ///< whether it ends where it starts

  const Outline* outline_;
  std::vector<std::vector<Vec2>> polylines_;  ///< by piece
};

/// Leading singular term of the guiding field at a junction of the boundary, and the number of layers of a fan that
/// resolves it.
///
/// After subtraction of the exact lifting of the jump, the field at a junction of interior angle omega contains r^alpha
/// terms (lib/method.md §3):
///   pi / omega = n an integer, straight sides   none: the field is smooth
///   pi / omega = n >= 2, a curved side          r^n log r
///   omega = pi, the curvature jumps             r log r;   its derivative jumps: r^2 log r
///   any other omega                             r^(pi / omega)
///
/// Where the jump is bridged (at enclosed joints), the field depends on the angle alone down to the length r0 of the
/// bridge, which disturbs it by (r0 / r)^(2 pi / omega), whatever the order: as many layers as for r^(pi / omega) of
/// amplitude 1 with apex elements that resolve nothing of it.
struct Singularity {
  double exponent = 0;   ///< alpha; 0: the field is smooth
  double amplitude = 0;  ///< of the term at the fan's radius; at most 1, as |v| = 1 on the boundary
  int apex_order = 8;  ///< of the elements at the apex, which leave 1 / apex_order^(2 alpha) of the term; 1: all of it
};

/// The leading term for a fan of radius `radius`.
Singularity junction_singularity(const Junction& junction, double radius);

/// ln(tol / a^2) / (2 alpha ln factor), tol = 1e-10, a = amplitude / apex_order^(2 alpha): the number of rings after
/// which what the apex elements leave of the term is below tol in the far field. 0 if it is so without a fan.
int fan_layers(const Singularity& singularity, double factor);

/// The greatest length of the element edges at a junction without a fan where only the derivative of the curvature
/// jumps, as at every knot of a C2 spline: on longer elements the term r^2 log r is above what order 20 resolves.
/// Infinite if nothing jumps.
double greatest_edge_length(const Junction& junction);

}  // namespace quadrille::triangulate
