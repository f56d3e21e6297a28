#pragma once
// A smooth distance to the boundary:
//
//   delta(x) = pi / oint ds / |x - y(s)|^2
//
// the distance to a straight boundary, (R^2 - r^2) / (2 R) in a disc. It tends to the ordinary distance at a smooth
// boundary, has no kinks where two curves are equally near, and is equivariant under rigid motions and scaling.

#include <array>
#include <vector>

#include "curve/face_boundary.hpp"
#include "curve/symmetry.hpp"
#include "model/cad_face.hpp"

namespace quadrille::placement {

/// Positions are relative to face.origin, lengths in the file's unit.
class SmoothBoundaryDistance : public curve::FaceBoundary {
 public:
  /// Cuts the curves into pieces on which 16 Gauss points are exact.
  explicit SmoothBoundaryDistance(const CadFace& face);

  /// ln delta(x) and its gradient, to 1e-12; x must not lie on the boundary. Linear in the number of curves.
  double log_smooth(Vec2 x, Vec2& gradient) const;

 private:
  struct Piece {
    int curve = 0;
    double t0 = 0, t1 = 0;  ///< parameters
    double length = 0;
    std::array<Vec2, 16> points;
    std::array<double, 16> weights;  ///< of arc length
  };
  struct Integral;

  Piece piece(int curve, double t0, double t1) const;
  void cut(int curve, double t0, double t1, int depth);
  void add(const Piece& piece, Vec2 x, int depth, Integral& sum) const;

  std::vector<Piece> pieces_;
};

/// The middle of a face: the point with the largest smooth distance to the boundary among those that are
/// invariant under `group`: if it has a mirror axis, on the axis. Not for groups with rotations, which have a single
/// invariant point.
Vec2 most_interior_point(const CadFace& face, const std::vector<curve::Isometry>& group);

}  // namespace quadrille::placement
