#include "topology/grid_kind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/tolerance.hpp"
#include "guide/valence.hpp"
#include "model/name_rules.hpp"

namespace quadrille::topology {
namespace {

/// Whether a slit joins a body to the outline.
bool has_slit(const CadFace& face) {
  for (int j = 0; j < face.loop_offsets[1]; ++j)
    if (face.is_interface(j)) return true;
  return false;
}

/// Whether the corner belongs to the outline, not to a body that a slit joins to it.
bool is_outline(const CadFace& face, int joint) {
  if (face.loop_of(joint) != 0) return false;
  return !has_slit(face) || (is_far_field(face, joint) && is_far_field(face, face.previous_in_loop(joint)));
}

/// The direction in which the body points at this joint of a hole: away from the body, along the bisector.
Vec2 direction_of(const Joint& joint) { return unit(joint.tangent_out + joint.interior_angle / 2); }

std::vector<Vec2> outline_corners(const CadFace& face) {
  std::vector<Vec2> corners;
  for (int j = 0; j < face.loop_offsets[1]; ++j)
    if (face.joints[j].is_corner && is_outline(face, j)) corners.push_back(face.joints[j].position);
  return corners;
}

/// Whether a corner of the outline belongs to its outflow. Two corners have it between them; of more, those downstream
/// of their centre do: seen from there, not from a body that may be near the outflow, they are farthest from being
/// beside it.
bool is_downstream(const CadFace& face, Vec2 position) {
  const std::vector<Vec2> corners = outline_corners(face);
  if (corners.size() <= 2) return true;
  Vec2 centre;
  for (const Vec2 corner : corners) centre += corner / static_cast<double>(corners.size());
  return dot(position - centre, downstream(face)) > tolerance::tied * face.diameter;
}

/// The least valence with blocks below the greatest admissible angle.
int least_valence(double angle_degrees) {
  return static_cast<int>(std::ceil(angle_degrees / guide::greatest_block_angle - tolerance::tied));
}

int valence_of(const CadFace& face, GridKind kind, const Corner& c) {
  if (kind == GridKind::h) return c.valence;
  if (is_outline(face, c.joint)) return kind == GridKind::o || !is_downstream(face, c.position) ? 2 : c.valence;
  return kind == GridKind::o && c.angle_degrees > 180 ? least_valence(c.angle_degrees) : c.valence;
}

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

GridKind kind_of_outline(const CadFace& face) {
  if (face.num_loops() < 2 && !has_slit(face)) return GridKind::none;
  int named = 0;
  for (int j = 0; j < face.loop_offsets[1]; ++j)
    if (is_far_field(face, j)) ++named;
  const std::size_t corners = outline_corners(face).size();
  if (named == 0 || (named < face.loop_offsets[1] && !has_slit(face))) return GridKind::none;
  if (corners == 0 && num_bodies(face) > 1) return GridKind::none;  // lines that go around one body meet the other
  return corners == 0 ? GridKind::o : corners == 2 ? GridKind::c : corners == 4 ? GridKind::h : GridKind::none;
}

int num_bodies(const CadFace& face) {
  int bodies = 0;
  for (int loop = 0; loop < face.num_loops(); ++loop) {
    const int region = face.region_of_loop(loop);
    if (loop == (face.region_loops.empty() ? 0 : face.region_loops[region])) continue;
    for (int c = face.loop_offsets[loop]; c < face.loop_offsets[loop + 1]; ++c) {
      if (face.is_interface(c)) continue;
      ++bodies;
      break;
    }
  }
  return bodies;
}

std::vector<GridKind> other_grids(const CadFace& face) {
  std::vector<GridKind> grids;
  const GridKind own = kind_of_outline(face);
  if (own == GridKind::none) return grids;
  for (const GridKind grid : {GridKind::h, GridKind::c, GridKind::o})
    if (grid != own) grids.push_back(grid);
  return grids;
}

void require_holes(const CadFace& face, GridKind kind) {
  const bool has_hole = face.num_loops() > face.num_regions() || !face.partners.empty();
  if (!has_hole && kind != GridKind::by_outline && kind != GridKind::none)
    throw UsageError(
        fmt::format("a C-, O- or H-grid is made around a hole, and the face has none: leave --topology {} "
                    "out",
                    enum_name(kind)));
}

Vec2 downstream(const CadFace& face) {
  Vec2 sum;
  double weights = 0;
  for (int j = face.loop_offsets[1]; j < face.num_curves(); ++j) {
    const double turn = face.joints[j].interior_angle - pi;
    if (!face.joints[j].is_corner || turn < tolerance::same_angle) continue;
    sum += turn * turn * direction_of(face.joints[j]);
    weights += turn * turn;
  }
  return norm(sum) > 0.1 * weights ? sum / norm(sum) : Vec2{1, 0};
}

std::vector<guide::CornerOverride> grid_corners(const CadFace& face, GridKind kind, const CriticalPoints& points) {
  std::vector<guide::CornerOverride> corners;
  if (kind == GridKind::none) return corners;
  for (const Corner& c : points.corners) {
    const int valence = valence_of(face, kind, c);
    if (valence != c.valence && may_change(c) && guide::is_admissible_valence(c.angle_degrees, valence))
      corners.push_back({c.curves[0], c.curves[1], valence});
  }
  return corners;
}

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
