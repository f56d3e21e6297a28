#include "couple/boundary_point.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "curve/nurbs.hpp"
#include "curve/project.hpp"
#include "model/periodic.hpp"

namespace quadrille::couple {
namespace {

// The next sector about a joint in clockwise direction lies behind the outgoing curve.
std::optional<BoundaryPoint> behind_outgoing(const CadFace& face, int joint) {
  if (!face.is_interface(joint)) return std::nullopt;
  return boundary_point(face, face.partners[joint], face.curves[face.partners[joint]].end());
}

// In counter-clockwise direction it lies behind the incoming curve.
std::optional<BoundaryPoint> behind_incoming(const CadFace& face, int joint) {
  const int incoming = face.previous_in_loop(joint);
  if (!face.is_interface(incoming)) return std::nullopt;
  return boundary_point(face, face.partners[incoming], face.curves[face.partners[incoming]].begin());
}

}  // namespace

Vec2 BoundaryPoint::position(const CadFace& face) const {
  return is_joint(face) ? face.joints[curve].position : curve::point(face.curves[curve], t);
}

BoundaryPoint boundary_point(const CadFace& face, int curve, double t) {
  if (t < face.curves[curve].end()) return {curve, t};
  const int next = face.next_in_loop(curve);
  return {next, face.curves[next].begin()};
}

BoundaryPoint nearest_boundary_point(const CadFace& face, int loop, Vec2 position) {
  constexpr double relative_joint = 1e-9;  // relative to the diameter
  BoundaryPoint best;
  double least = std::numeric_limits<double>::infinity();
  for (int c = face.loop_offsets[loop]; c < face.loop_offsets[loop + 1]; ++c) {
    if (distance(face.joints[c].position, position) <= relative_joint * face.diameter)
      return {c, face.curves[c].begin()};
    const curve::Projection p = curve::project(face.curves[c], position);
    if (p.distance < least) {
      least = p.distance;
      best = boundary_point(face, c, p.t);
    }
  }
  return best;
}

BoundaryPoint opposite_point(const CadFace& face, const BoundaryPoint& point, int partner) {
  return boundary_point(face, partner, periodic_parameter(face, point.curve, point.t, partner));
}

std::vector<BoundaryPoint> coincident_points(const CadFace& face, const BoundaryPoint& point) {
  std::vector<BoundaryPoint> points{point};
  if (!point.is_joint(face)) {
    if (face.is_interface(point.curve)) points.push_back(opposite_point(face, point, face.partners[point.curve]));
  } else {
    for (auto next = behind_incoming(face, point.curve); next; next = behind_incoming(face, next->curve)) {
      if (*next == point) break;
      points.push_back(*next);
    }
    if (!is_inside_whole(face, point)) {
      std::vector<BoundaryPoint> before;
      for (auto next = behind_outgoing(face, point.curve); next; next = behind_outgoing(face, next->curve))
        before.push_back(*next);
      points.insert(points.begin(), before.rbegin(), before.rend());
      return points;
    }
  }
  std::rotate(points.begin(), std::min_element(points.begin(), points.end()), points.end());
  return points;
}

bool is_inside_whole(const CadFace& face, const BoundaryPoint& point) {
  if (!point.is_joint(face)) return face.is_interface(point.curve);
  for (auto next = behind_incoming(face, point.curve); next; next = behind_incoming(face, next->curve))
    if (*next == point) return true;
  return false;
}

}  // namespace quadrille::couple
