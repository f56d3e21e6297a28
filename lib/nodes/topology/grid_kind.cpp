#include "topology/grid_kind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/tolerance.hpp"
#include "guide/admissible_valence.hpp"
#include "model/special_names.hpp"

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
    if (valence != c.valence && c.source != NodeSource::corner && c.source != NodeSource::divide &&
        guide::is_admissible_valence(c.angle_degrees, valence))
      corners.push_back({c.curves[0], c.curves[1], valence});
  }
  return corners;
}

}  // namespace quadrille::topology
