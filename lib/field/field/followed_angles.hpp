#pragma once
// Continuous angles along a loop of the boundary: of the tangent, and of the vectors from fixed centres to the point of
// the loop. Each curve is divided into pieces on which every angle provably differs by less than a quarter turn from a
// reference, so that no turn is missed, however near a centre is to the boundary.

#include <span>
#include <vector>

#include "base/angle.hpp"
#include "field/explicit_terms.hpp"
#include "model/cad_face.hpp"

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

}  // namespace quadrille::field
