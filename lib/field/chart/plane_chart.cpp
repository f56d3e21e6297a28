#include "chart/plane_chart.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "chart/chart_outline.hpp"
#include "mesh/tri_topology.hpp"
#include "spectral/tri_map.hpp"
#include "surface/nurbs_surface.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille::chart {
namespace {

constexpr double off_plane = 1e-10;  ///< of the size of the poles: rounding of a file
constexpr int plane_order = 8;

struct Plane {
  Vec3 origin, x, y;
  Vec2 at(Vec3 a) const { return {dot(a - origin, x), dot(a - origin, y)}; }
  Vec3 lift(Vec2 a) const { return origin + a.x * x + a.y * y; }
};

/// The plane of the face with its normal; std::nullopt if its poles are in none.
std::optional<Plane> plane_of(const SpaceFace& face) {
  const NurbsSurface& s = face.surface;
  const Vec2 middle{(s.knots_u.front() + s.knots_u.back()) / 2, (s.knots_v.front() + s.knots_v.back()) / 2};
  const Vec3 normal = face_normal(face, middle);
  if (!(norm2(normal) > 0)) return std::nullopt;
  Plane plane{surface::point(s, middle), {}, {}};
  std::vector<Vec3> poles = s.poles;
  for (const SpaceCurve& curve : face.curves) poles.insert(poles.end(), curve.poles.begin(), curve.poles.end());
  double size = 0, off = 0;
  for (const Vec3 p : poles) {
    size = std::max(size, norm(p - plane.origin));
    off = std::max(off, std::abs(dot(p - plane.origin, normal)));
  }
  if (off > off_plane * size) return std::nullopt;
  const Vec3 xu = surface::evaluate(s, middle).xu;
  plane.x = normalized(xu - dot(xu, normal) * normal), plane.y = cross(normal, plane.x);
  return plane;
}

Nurbs in_plane(const SpaceCurve& curve, const Plane& plane) {
  Nurbs flat{curve.degree, curve.knots, {}, curve.weights};
  for (const Vec3 p : curve.poles) flat.poles.push_back(plane.at(p));
  return flat;
}

SurfaceMesh mesh_of(const CadFace& face, const SpaceFace& space_face, const Plane& plane) {
  triangulate::TriangulateOptions options;
  options.order = plane_order;
  Report unused;
  SurfaceMesh mesh;
  mesh.order = plane_order;
  mesh.plane = triangulate::triangulate(face, options, unused);
  const NurbsSurface& s = space_face.surface;
  Vec2 uv{(s.knots_u.front() + s.knots_u.back()) / 2, (s.knots_v.front() + s.knots_v.back()) / 2};
  for (const spectral::TriMap& map : mesh::tri_maps(mesh.plane))
    for (const Vec2 xi : spectral::tri_nodes(plane_order)) {
      const Vec2 x = map.position(xi);
      mesh.image.push_back(x);
      mesh.nodes.push_back(plane.lift(x));
      uv = surface::project(s, mesh.nodes.back(), uv).uv;
      mesh.uv.push_back(uv);
      mesh.scale.push_back(0);
    }
  return mesh;
}

}  // namespace

std::optional<PlaneChart> plane_chart(const SpaceFace& space_face, double corner_angle) {
  const std::optional<Plane> plane = plane_of(space_face);
  if (!plane) return std::nullopt;
  CadFace face = space_face.face;
  face.curves.clear(), face.joints.clear();
  for (const SpaceCurve& curve : space_face.curves) face.curves.push_back(in_plane(curve, *plane));
  for (int i = 0; i < face.num_curves(); ++i) {
    const Vec3 normal = cross(plane->x, plane->y);
    face.joints.push_back(joint_of(face, i, space_angle(space_face, i, normal), corner_angle));
  }
  face.diameter = outline_diameter(face);
  SurfaceMesh mesh = mesh_of(face, space_face, *plane);
  return PlaneChart{std::move(face), std::move(mesh)};
}

}  // namespace quadrille::chart
