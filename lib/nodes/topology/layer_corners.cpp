#include "topology/layer_corners.hpp"

#include <algorithm>
#include <cmath>

#include "guide/tie_measures.hpp"
#include "model/special_names.hpp"
#include "topology/grid_kind.hpp"

namespace quadrille::topology {
namespace {

constexpr double equal_angle = 1;  // degrees: corners of a wall and of its offset curve add up to 360

bool may_change(const Corner& c) { return c.source != NodeSource::corner && c.source != NodeSource::divide; }

/// Whether all curves of a hole have offset curves.
bool is_closed_wall(const CadFace& face, int loop) {
  if (loop == 0) return false;
  const auto names = face.curve_names.begin();
  return std::all_of(names + face.loop_offsets[loop], names + face.loop_offsets[loop + 1],
                     [&](const std::string& name) { return has_offset(face, name); });
}

bool is_wall_corner(const CadFace& face, const Corner& c) {
  return c.valence == 3 && may_change(c) && is_closed_wall(face, face.loop_of(c.joint));
}

bool is_offset_corner(const CadFace& face, const Corner& c) {
  return c.valence == 1 && may_change(c) && is_offset_name(face.curve_names[c.curves[0]]) &&
         is_offset_name(face.curve_names[c.curves[1]]);
}

/// The corner nearest to the position of those for which `is_one` holds; nullptr if it holds for none.
template <typename IsOne>
const Corner* nearest(const std::vector<Corner>& corners, Vec2 position, const IsOne& is_one) {
  const Corner* best = nullptr;
  for (const Corner& c : corners)
    if (is_one(c) && (!best || distance(c.position, position) < distance(best->position, position))) best = &c;
  return best;
}

/// The corner of the offset curve that lies opposite to the wall's corner: each is the nearest of its kind to the
/// other, and their angles add up to 360 degrees. nullptr if there is no such corner.
const Corner* opposite_corner(const CadFace& face, const CriticalPoints& points, const Corner& wall) {
  const Corner* offset =
      nearest(points.corners, wall.position, [&](const Corner& c) { return is_offset_corner(face, c); });
  if (!offset || std::abs(offset->angle_degrees + wall.angle_degrees - 360) > equal_angle) return nullptr;
  const Corner* back =
      nearest(points.corners, offset->position, [&](const Corner& c) { return is_wall_corner(face, c); });
  return back == &wall ? offset : nullptr;
}

bool has_long_sides(const CadFace& face, const Corner& wall, double thickness) {
  return std::all_of(wall.curves.begin(), wall.curves.end(),
                     [&](int curve) { return guide::side_length(face, curve) > thickness; });
}

}  // namespace

LayerCorners layer_corners(const CadFace& whole, LayerCorners corners) {
  if (corners != LayerCorners::by_bodies) return corners;
  return num_bodies(whole) > 1 ? LayerCorners::close : LayerCorners::pass;
}

std::vector<guide::CornerOverride> closed_layer_corners(const CadFace& face, const CriticalPoints& points) {
  std::vector<guide::CornerOverride> corners;
  for (const Corner& wall : points.corners) {
    if (!is_wall_corner(face, wall)) continue;
    const Corner* offset = opposite_corner(face, points, wall);
    if (!offset || !has_long_sides(face, wall, distance(wall.position, offset->position))) continue;
    for (const Corner* c : {&wall, offset}) corners.push_back({c->curves[0], c->curves[1], 2});
  }
  return corners;
}

}  // namespace quadrille::topology
