#pragma once
// The motion of a sweep: where the face is at the fraction s of it, from 0 (the face itself) to 1.
//
// First the face is turned by s * twist about its centre and scaled there by 1 + s (taper - 1), both in its plane. Then
// it is moved: by s times a vector, by s * angle about an axis, or along a curve c from c(0) to c(s), turned so that
// the tangent stays with it and it does not turn about the tangent (parallel transport, by double reflection: W. Wang
// et al., Computation of rotation minimizing frames, ACM Trans. Graph. 27 (2008)). At each s that is an affine map.

#include <optional>
#include <vector>

#include "base/vec3.hpp"
#include "model/hex_mesh.hpp"
#include "surface/periodic_motion.hpp"
#include "sweep/space_spline.hpp"

namespace quadrille::sweep {

struct Axis {
  Vec3 point, direction;  ///< of unit length
};

/// One of `along`, `axis` and `curve` decides.
struct SweepShape {
  Vec3 along;
  std::optional<Axis> axis;
  double angle = 0;         ///< radians, about the axis
  std::vector<Vec3> curve;  ///< points
  double twist = 0;         ///< radians
  double taper = 1;         ///< > 0
  Vec3 centre, normal;      ///< of twist and taper
};

/// x -> matrix x + shift: the second of the two motions after the first.
SpaceMotion combined(const SpaceMotion& first, const SpaceMotion& second);
using surface::image;
/// A rotation about an axis.
SpaceMotion rotation(const Axis& axis, double angle);

class SweepMotion {
 public:
  explicit SweepMotion(SweepShape shape);

  SpaceMotion at(double s) const;
  const SweepShape& shape() const { return shape_; }
  /// Of the vector or of the curve; of a revolution 0.
  double length() const;
  /// Whether the face is moved as a rigid body, and equal steps of s are equal motions.
  bool is_steady() const { return !spline_ && shape_.taper == 1; }
  /// Whether nothing but a translation happens.
  bool is_straight() const { return is_steady() && !shape_.axis && shape_.twist == 0; }
  bool is_rigid() const { return shape_.taper == 1; }
  /// A full turn: the end is the beginning.
  bool is_closed() const;

 private:
  SpaceMotion in_plane(double s) const;
  SpaceMotion along_curve(double s) const;

  SweepShape shape_;
  std::optional<SpaceSpline> spline_;
  std::vector<Vec3> normals_;  ///< along the curve, at equal steps of each span: carried by parallel transport
};

}  // namespace quadrille::sweep
