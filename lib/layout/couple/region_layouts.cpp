#include "couple/region_layouts.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/tolerance.hpp"
#include "curve/face_boundary.hpp"
#include "curve/nurbs.hpp"
#include "model/periodic.hpp"

namespace quadrille::couple {
namespace {

// The next sector about a joint: clockwise it lies behind the outgoing curve, counter-clockwise behind the incoming
// one.
std::optional<BoundaryPoint> next_sector(const CadFace& face, int joint, bool is_clockwise) {
  const int curve = is_clockwise ? joint : face.previous_in_loop(joint);
  if (!face.is_interface(curve)) return std::nullopt;
  const Nurbs& partner = face.curves[face.partners[curve]];
  return boundary_point(face, face.partners[curve], is_clockwise ? partner.end() : partner.begin());
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
  for (int c = face.loop_offsets[loop]; c < face.loop_offsets[loop + 1]; ++c)
    if (distance(face.joints[c].position, position) <= tolerance::round_off * face.diameter)
      return {c, face.curves[c].begin()};
  const curve::NearestPoint nearest =
      curve::CurveTree(face.curves).nearest(position, [&](int c) { return face.loop_of(c) == loop; });
  return boundary_point(face, nearest.curve, nearest.t);
}

BoundaryPoint opposite_point(const CadFace& face, const BoundaryPoint& point, int partner) {
  return boundary_point(face, partner, periodic_parameter(face, point.curve, point.t, partner));
}

std::vector<BoundaryPoint> coincident_points(const CadFace& face, const BoundaryPoint& point) {
  std::vector<BoundaryPoint> points{point};
  if (!point.is_joint(face)) {
    if (face.is_interface(point.curve)) points.push_back(opposite_point(face, point, face.partners[point.curve]));
  } else {
    for (auto next = next_sector(face, point.curve, false); next; next = next_sector(face, next->curve, false)) {
      if (*next == point) break;
      points.push_back(*next);
    }
    if (!is_inside_whole(face, point)) {
      std::vector<BoundaryPoint> before;
      for (auto next = next_sector(face, point.curve, true); next; next = next_sector(face, next->curve, true))
        before.push_back(*next);
      points.insert(points.begin(), before.rbegin(), before.rend());
      return points;
    }
  }
  std::rotate(points.begin(), std::min_element(points.begin(), points.end()), points.end());
  return points;
}

std::vector<std::vector<LineKind>> RegionLayouts::line_kinds() const {
  std::vector<std::vector<LineKind>> kinds;
  for (const graph::CandidateLayout& layout : layouts)
    kinds.push_back(graph::spline_kinds(layout.graph(), layout.lines));
  return kinds;
}

void RegionLayouts::rebuild_lines(std::vector<std::vector<LineKind>> kinds, LineKind added) {
  for (std::size_t r = 0; r < kinds.size(); ++r) graph::rebuild_lines(layouts[r], std::move(kinds[r]), added);
}

bool is_inside_whole(const CadFace& face, const BoundaryPoint& point) {
  if (!point.is_joint(face)) return face.is_interface(point.curve);
  for (auto next = next_sector(face, point.curve, false); next; next = next_sector(face, next->curve, false))
    if (*next == point) return true;
  return false;
}

}  // namespace quadrille::couple
