#pragma once
// Dirichlet data of the guiding field from the exact tangents of the CAD curves (paper, eq. 3).

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

/// lifted_boundary_value() on a mesh, with a bridge over each jump that has no lifting: along the two element edges at
/// the corner the data change linearly, in the parameter, to the mean of both sides at the corner. The two deviations
/// are opposite, so that the field is disturbed by (r0 / r)^(2 pi / omega) only, r0 the length of the edges: the fan of
/// such a corner makes it negligible (triangulate/singularity.hpp).
class BoundaryValues {
 public:
  /// `mesh` must outlive this object.
  BoundaryValues(const TriMesh& mesh, std::vector<Lifting> liftings);
  Vec2 operator()(int curve, double t) const;

 private:
  struct Bridge {
    double t_corner = 0, t_edge = 0;  ///< ends of the element edge at the corner
    Vec2 mean;
  };
  const CadFace* face_;
  std::vector<Lifting> liftings_;
  std::vector<std::vector<Bridge>> bridges_;  ///< by curve; empty: there are none
};

/// Whether all boundary values lie on one line through 0, on both sides of 0: straight sides at odd and at even
/// multiples of 45 degrees. The field then vanishes along curves, and the harmonic method yields no layout
/// (lib/method.md §3).
bool is_line_field(const CadFace& face);

}  // namespace quadrille::field
