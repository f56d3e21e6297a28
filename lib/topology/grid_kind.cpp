#include "topology/grid_kind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "guide/admissible_valence.hpp"
#include "model/far_field.hpp"

namespace quadrille::topology {
namespace {

constexpr double equal = 1e-6;  // radians, or relative to the diameter

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

/// The corners of holes with the greatest angle, if that is more than 180 degrees.
std::vector<int> sharpest_joints(const CadFace& face) {
  double greatest = pi + equal;
  std::vector<int> joints;
  for (int j = face.loop_offsets[1]; j < face.num_curves(); ++j) {
    const double angle = face.joints[j].interior_angle;
    if (!face.joints[j].is_corner || angle < greatest - equal) continue;
    if (angle > greatest + equal) joints.clear();
    greatest = std::max(greatest, angle);
    joints.push_back(j);
  }
  return joints;
}

bool is_downstream(const CadFace& face, Vec2 position) {
  Vec2 from;
  const std::vector<int> joints = sharpest_joints(face);
  for (const int j : joints) from += face.joints[j].position / static_cast<double>(joints.size());
  return dot(position - from, downstream(face)) > equal * face.diameter;
}

/// The least valence with blocks below the greatest admissible angle.
int least_valence(double angle_degrees) {
  return static_cast<int>(std::ceil(angle_degrees / guide::greatest_block_angle - equal));
}

int valence_of(const CadFace& face, GridKind kind, const Corner& c) {
  if (kind == GridKind::h) return c.valence;
  if (is_outline(face, c.joint)) return kind == GridKind::o || !is_downstream(face, c.position) ? 2 : c.valence;
  return kind == GridKind::o && c.angle_degrees > 180 ? least_valence(c.angle_degrees) : c.valence;
}

}  // namespace

GridKind kind_of_outline(const CadFace& face) {
  if (face.num_loops() < 2 && !has_slit(face)) return GridKind::none;
  int corners = 0, named = 0;
  for (int j = 0; j < face.loop_offsets[1]; ++j) {
    if (is_far_field(face, j)) ++named;
    if (face.joints[j].is_corner && is_outline(face, j)) ++corners;
  }
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
  for (const int j : sharpest_joints(face)) sum += direction_of(face.joints[j]);
  return norm(sum) > equal ? sum / norm(sum) : Vec2{1, 0};
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
