#include "field/hole_points.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "base/segments.hpp"
#include "curve/nurbs.hpp"
#include "field/corner_lifting.hpp"

namespace quadrille::field {

namespace {

// Sufficient fraction of the greatest clearance: the farther h_j is from the boundary, the smoother the data.
constexpr double good_clearance = 0.8;

using Polygon = std::vector<Vec2>;

Polygon sampled_loop(const CadFace& face, int loop) {
  constexpr int samples = 32;
  Polygon polygon;
  for (int c = face.loop_offsets[loop]; c < face.loop_offsets[loop + 1]; ++c) {
    const Nurbs& curve = face.curves[c];
    for (int i = 0; i < samples; ++i)
      polygon.push_back(curve::point(curve, curve.begin() + (curve.end() - curve.begin()) * i / samples));
  }
  return polygon;
}

// Area and first moments from triangles about the first point.
Vec2 centroid(const Polygon& polygon) {
  const Vec2 base = polygon.front();
  double area = 0;
  Vec2 moment;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Vec2 a = polygon[i] - base, b = polygon[i + 1] - base;
    area += cross(a, b);
    moment += cross(a, b) * (a + b) / 3.0;
  }
  return base + moment / area;
}

// Distance to the polygon, negative outside.
double signed_clearance(const Polygon& polygon, Vec2 x) {
  double nearest = INFINITY;
  bool is_inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    nearest = std::min(nearest, distance_to_segment(x, a, b));
    if ((a.y > x.y) != (b.y > x.y) && x.x < a.x + (b.x - a.x) * (x.y - a.y) / (b.y - a.y)) is_inside = !is_inside;
  }
  return is_inside ? nearest : -nearest;
}

Vec2 hole_point(const CadFace& face, int loop) {
  const Polygon polygon = sampled_loop(face, loop);
  const Vec2 centre = centroid(polygon);
  Vec2 best;
  double most = -INFINITY;
  for (int c = face.loop_offsets[loop]; c < face.loop_offsets[loop + 1]; ++c) {
    if (face.is_interface(c)) continue;  // behind a slit is the face
    const Nurbs& curve = face.curves[c];
    for (const double f : {0.5, 0.25, 0.75, 0.1, 0.9}) {
      const double t = curve.begin() + f * (curve.end() - curve.begin());
      const Vec2 x = half_way(face, curve::point(curve, t), -left_of(curve::tangent(curve, t)));
      const double clearance = signed_clearance(polygon, x);
      if (clearance > most * (1 + 1e-6)) most = clearance, best = x;
    }
  }
  return signed_clearance(polygon, centre) >= good_clearance * most ? centre : best;
}

// Outside of the outline: the term there has no turns (field/corner_terms.cpp), but its position has to be finite.
Vec2 point_beyond(const CadFace& face, int loop) {
  const Joint& joint = face.joints[face.loop_offsets[loop]];
  return joint.position + 3 * face.diameter * unit(joint.tangent_out);
}

}  // namespace

std::vector<Vec2> hole_points(const CadFace& face) {
  std::vector<Vec2> points;
  for (int loop = 1; loop < face.num_loops(); ++loop)
    points.push_back(face.is_slit_loop(loop) ? point_beyond(face, loop) : hole_point(face, loop));
  return points;
}

}  // namespace quadrille::field
