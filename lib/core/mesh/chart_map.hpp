#pragma once
// From the plane of a chart to the surface (lib/method.md §12).
//
// A point of the chart lies in a triangle; the polynomial of its nodes in space is within the chart's accuracy of the
// surface, and is projected to it. So every lifted point is on the exact surface, and only its place along the surface
// has the error of the chart.

#include <array>
#include <optional>
#include <vector>

#include "base/vec3.hpp"
#include "mesh/locate.hpp"
#include "model/cad_face.hpp"
#include "model/tri_mesh.hpp"
#include "spectral/tri_map.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::mesh {

/// The triangles of the face's chart, all curved, as a mesh without boundary edges; vertices in the order in which
/// elements name them.
TriMesh chart_triangles(const CadFace& face);

class ChartMap {
 public:
  /// The face must have a chart and outlive this.
  explicit ChartMap(const CadFace& face);
  ChartMap(const ChartMap&) = delete;
  ChartMap& operator=(const ChartMap&) = delete;

  /// The triangle of a point of the chart, relative to face.origin. Points outside all triangles (the boundary curves
  /// and the triangles are two approximations) are in the nearest one, beyond its edge.
  Location locate(Vec2 x) const;
  /// The point of the exact surface, in the coordinates of the CAD file.
  Vec3 lift(Vec2 x) const;
  /// lambda: the logarithm of a length in space over one in the chart.
  double log_scale(Vec2 x) const;
  /// The same and its gradient in the chart.
  double log_scale(Vec2 x, Vec2& gradient) const;
  /// A point of the polynomial, near the surface but not projected to it, with lambda.
  struct Sample {
    Vec3 position;
    double log_scale = 0;
  };
  Sample sample(Vec2 x) const;
  /// The derivatives of the position in space by the coordinates of the chart.
  std::array<Vec3, 2> derivatives(Vec2 x) const;
  /// The bound of the gradient of lambda in space, by the nodes of all triangles: 1 over a length in space.
  double greatest_gradient() const;
  /// The point of the chart whose point in space is the nearest one of the face, and how far that is.
  struct Foot {
    Vec2 x;
    double distance = 0;
  };
  Foot nearest(Vec3 position) const;
  /// The unit normal of the surface, on the side from which the chart is seen counter-clockwise.
  Vec3 normal(Vec2 x) const;
  /// The greatest curvature (1 / length) of the surface at the lifted point, by surface::greatest_curvature.
  double greatest_curvature(Vec2 x) const;
  /// The exact point of the boundary at a parameter of curve i.
  Vec3 boundary_point(int curve, double t) const;
  /// How far a point in space, near the lifted one of the chart's point x, is from the surface. `uv`: parameters of a
  /// point of the surface near by, if known, from which the nearest one is found faster; becomes that one's.
  double distance_from_surface(Vec3 position, Vec2 x, std::optional<Vec2>& uv) const;

 private:
  Vec3 on_polynomial(Location at) const;
  /// The nearest point of the surface of the triangle.
  surface::SurfaceProjection projected(Vec3 position, Location at) const;
  bool is_near(const surface::SurfaceProjection& foot) const;
  struct Tangents;
  Tangents tangents(Location at) const;

  /// Around a triangle, in the chart and in space.
  struct Ball {
    Vec2 centre;
    double radius = 0;
    Vec3 space_centre;
    double space_radius = 0;
  };
  Ball ball_around(int elem) const;
  std::optional<Foot> foot_on(int elem, Vec3 position) const;

  const CadFace& face_;
  const Chart& chart_;
  std::vector<spectral::TriMap> maps_;           ///< to the chart
  std::vector<spectral::TriMap> space_xy_;       ///< to x and y in space
  std::vector<spectral::TriMap> space_z_scale_;  ///< to z in space and lambda
  Locator locator_;
  std::vector<Ball> balls_;
};

}  // namespace quadrille::mesh
