#pragma once
// Dirichlet data of the guiding field from the exact tangents of the CAD curves (paper, eq. 3), and exact harmonic
// liftings of their jumps at corners (lib/method.md §3, §8.4).
//
// At a corner c the data jump from v_in (end of the incoming curve) to v_out (start of the outgoing one). The function
// jump * theta_c(x), theta_c = Arg((z - c)/(z - p_c)), is harmonic in the domain and has exactly that jump at c: after
// subtracting it, the data are continuous at c.

#include <optional>
#include <vector>

#include "model/cad_face.hpp"
#include "model/field.hpp"
#include "model/tri_mesh.hpp"

namespace quadrille::field {

/// (cos 4 theta, sin 4 theta) of the curve's tangent at t; one-sided at the curve's ends.
Vec2 boundary_value(const CadFace& face, int curve, double t);

/// The sum of the liftings at parameter t of `curve`. At an end of the curve, the lifting of that joint is evaluated as
/// its limit along the curve.
Vec2 liftings_on_boundary(const CadFace& face, const std::vector<Lifting>& liftings, int curve, double t);

/// boundary_value minus all liftings, at parameter t of `curve`: continuous around every loop.
Vec2 lifted_boundary_value(const CadFace& face, const std::vector<Lifting>& liftings, int curve, double t);

/// Bridges over jumps of the boundary data at enclosed joints (model/interfaces.hpp), at slits and where a region
/// touches itself: no explicit term can represent them, because there is no place for its pole, or because one term
/// would have to carry the jumps of several sectors. Along the two element edges at such a corner the data change
/// linearly, in the parameter, to the mean of both sides at the corner. The two deviations are opposite, so that the
/// field is disturbed by (r0 / r)^(2 pi / omega) only, r0 the length of the edges: the fan of such a corner makes it
/// negligible (junction_singularity in triangulate/outline.hpp).
class CornerBridges {
 public:
  /// Bridges at all enclosed joints of the mesh's face. `mesh` must outlive this object.
  explicit CornerBridges(const TriMesh& mesh);
  /// A point of a bridge.
  struct Point {
    int joint = 0;
    double share = 0;  ///< 0: the mean at the joint holds; 1: the value of the curve
  };
  std::optional<Point> at(int curve, double t) const;
  /// values(curve, t), with bridges over its jumps at enclosed joints. Without a jump the values stay as they are.
  template <typename Values>
  Vec2 bridged(const Values& values, int curve, double t) const {
    const Vec2 value = values(curve, t);
    const auto bridge = at(curve, t);
    if (!bridge) return value;
    const int joint = bridge->joint, before = face_->previous_in_loop(joint);
    const Vec2 in = values(before, face_->curves[before].end()), out = values(joint, face_->curves[joint].begin());
    return value + (1 - bridge->share) * ((in + out) / 2 - (joint == curve ? out : in));
  }

 private:
  struct Edge {
    int joint = 0;
    double t_joint = 0, t_end = 0;
  };
  const CadFace* face_;
  std::vector<std::vector<Edge>> edges_;  ///< by curve; empty: no joint is enclosed
};

/// lifted_boundary_value() on a mesh, with bridges at enclosed joints: continuous around every loop.
class BoundaryValues {
 public:
  /// `mesh` must outlive this object.
  BoundaryValues(const TriMesh& mesh, std::vector<Lifting> liftings);
  Vec2 operator()(int curve, double t) const;

 private:
  const CadFace* face_;
  std::vector<Lifting> liftings_;
  CornerBridges bridges_;
};

/// Whether all boundary values lie on one line through 0, on both sides of 0: straight sides at odd and at even
/// multiples of 45 degrees. The field then vanishes along curves, and the harmonic method yields no layout
/// (lib/method.md §3).
bool is_line_field(const CadFace& face);

/// Smaller jumps of the data, of v or of the phase, are rounding of the decimals in the CAD file (a tangent jump of
/// 2.5e-11 radians). By the maximum principle the error of the field is no larger, and every lifting costs time at each
/// evaluation of the field.
inline constexpr double jump_tol = 1e-10;

/// The midpoint between `start`, a boundary point, and the first intersection of the boundary with the ray along the
/// unit vector `direction` out of the domain. The distance from `start` is at most the diameter.
Vec2 half_way(const CadFace& face, Vec2 start, Vec2 direction);

/// p_c for an apex on the boundary: half_way along the exterior bisector. `tangent_out`: unit tangent of the outgoing
/// side of the boundary at the apex; `interior_angle` in radians.
Vec2 exterior_pole(const CadFace& face, Vec2 apex, Vec2 tangent_out, double interior_angle);

/// The lifting at a joint where the function that it is made for jumps from `incoming` to `outgoing`; its pole is the
/// exterior_pole.
Lifting lifting_at(const CadFace& face, int joint, Vec2 incoming, Vec2 outgoing);

/// One lifting for every joint at which the data jump by more than round-off, except at enclosed ones (BoundaryValues
/// bridges those jumps).
std::vector<Lifting> corner_liftings(const CadFace& face);

}  // namespace quadrille::field
