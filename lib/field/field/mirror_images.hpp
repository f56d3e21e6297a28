#pragma once
// Images of a point in the boundary curves near it. If a* is the mirror image of a in a straight line, arg(z - a) +
// arg(z - a*) is constant along the line; for a circle, it is constant except for the arg of z about the centre. If the
// terms of the images are subtracted from the data of a phase, the data stay smooth however near a is to the boundary,
// where no mesh could resolve them otherwise. Any point outside the domain is equally valid: only accuracy depends on
// the choice.

#include <optional>
#include <vector>

#include "curve/face_boundary.hpp"
#include "model/cad_face.hpp"

namespace quadrille::field {

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
