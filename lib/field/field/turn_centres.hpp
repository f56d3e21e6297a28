#pragma once
// The centres of turns outside the domain (lib/method.md §8.3): in each hole a point h_j and, if it is not round, the
// foci of its bends; and the mirror images of nodes. Any other points there are equally valid: only accuracy depends on
// the choice.
//
// On an ellipse with foci f and f', 4 theta_t = 2 arg (z - f) + 2 arg (z - f') + const; on a parabola, 4 theta_t = 2
// arg (z - f) + const. Where the boundary of a hole turns by T in a sharp bend, 2 T / pi turns are therefore centred at
// the focus of the bend, at half its radius inside the hole. The remaining data are then resolved by a mesh that
// resolves the bend, however thin the hole.
//
// If a* is the mirror image of a in a straight line, arg(z - a) + arg(z - a*) is constant along the line; for a circle,
// it is constant except for the arg of z about the centre. If the terms of the images are subtracted from the data of a
// phase, the data stay smooth however near a is to the boundary, where no mesh could resolve them otherwise.

#include <optional>
#include <vector>

#include "curve/face_boundary.hpp"
#include "model/cad_face.hpp"

namespace quadrille::field {

/// The points h_j. For each hole (loops 1, 2, ...) its centroid. If the centroid lies outside the hole or much nearer
/// to the boundary than other points, the midpoint of the chord across the hole that has the greatest clearance. The
/// points move with the face and, if the centroid is used, do not depend on where the curves begin. For a loop of
/// slits, which encloses nothing, a joint of it: the turns are part of the jumps of the data there (lib/method.md §3).
std::vector<Vec2> hole_points(const CadFace& face);

/// The focus of one bend of a hole.
struct HoleFocus {
  Vec2 position;  ///< inside the hole
  int loop = 1;   ///< of the hole
  int turns = 1;  ///< nearest whole number to 2 T / pi, positive
};

/// The foci of all bends of all holes whose curvature is well above the mean of their hole; empty for a circle or a
/// polygon. Cost: linear in the number of curves.
std::vector<HoleFocus> hole_foci(const CadFace& face);

/// The mirror image of a node in one boundary curve.
struct MirrorImage {
  Vec2 position;  ///< outside the domain
  int loop = 0;   ///< 0: outside the outline; j: inside hole j
};

/// The images of points in the curves of one face.
class MirrorImages {
 public:
  /// `face` must outlive the object.
  explicit MirrorImages(const CadFace& face) : boundary_(face) {}
  /// Images of x, a point inside the domain, by inversion in the circles of curvature at its feet on the curves: at
  /// most one for each curve. A foot counts if its distance is at most a quarter of the diameter and at most three
  /// times the distance of the nearest foot, if x is not far from a bend of small radius, and if the image has
  /// clearance to the boundary on all sides outside the domain.
  std::vector<MirrorImage> of(Vec2 x) const;

 private:
  struct Candidate;
  std::optional<Candidate> candidate(const curve::NearestPoint& foot, Vec2 x) const;
  std::vector<Candidate> candidates(Vec2 x) const;

  curve::FaceBoundary boundary_;
};

}  // namespace quadrille::field
