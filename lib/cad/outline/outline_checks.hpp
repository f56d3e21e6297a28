#pragma once
// Checks whether a set of loops bounds one region. The checks use the curves, not polygons: each piece is enclosed by
// its chord and the greatest distance of a pole from the chord, and bisected until the check is decided.

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::outline {

/// Curves nearer to each other than this part of the diameter are in contact.
inline constexpr double contact_share = 1e-9;

/// A piece of a curve between knots; it lies within the distance `width` of its chord.
struct ChordPiece {
  explicit ChordPiece(Nurbs piece);

  Nurbs curve;
  double width = 0;

  Vec2 a() const { return curve.poles.front(); }
  Vec2 b() const { return curve.poles.back(); }
  /// The parameter at a part of the way, which is clamped to [0, 1].
  double at(double fraction) const {
    return curve.begin() + std::clamp(fraction, 0.0, 1.0) * (curve.end() - curve.begin());
  }
  std::pair<ChordPiece, ChordPiece> halves() const;
};

/// One for each knot span.
std::vector<ChordPiece> chord_pieces(const Nurbs& curve);

/// A position where two curves are closer than the tolerance without being neighbours there.
struct Contact {
  int loop_a = 0, curve_a = 0, loop_b = 0, curve_b = 0;
  Vec2 position;
  double t_a = 0, t_b = 0;  ///< its parameters on both curves
};

/// The first contact among the curves of all loops, including self-contact of a curve; std::nullopt for simple,
/// disjoint loops. `tol`: distance below which curves are in contact, a length.
std::optional<Contact> find_contact(const std::vector<std::vector<Nurbs>>& loops, double tol);

/// The winding number of the loop around x, positive if counter-clockwise; x must not lie on the loop.
int winding_number(const std::vector<Nurbs>& loop, Vec2 x);

}  // namespace quadrille::outline
