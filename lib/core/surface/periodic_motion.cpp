#include "surface/periodic_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/angle.hpp"
#include "base/tolerance.hpp"
#include "spectral/quadrature.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::surface {
namespace {

constexpr double least_area = 1e-3;  ///< of the square of the distance of both ends: else the side is a line

/// An end of a side, where the surface has this normal, of any length.
struct SideEnd {
  Vec3 position, normal;
};

/// What a motion moves along with a side. A side runs from its first to its last end; `area`: half of the integral of
/// (x - first) x dx.
struct SideShape {
  SideEnd first, last;
  Vec3 area;

  Vec3 chord() const { return last.position - first.position; }
  double area_beside_chord() const { return norm(cross(area, normalized(chord()))) / norm2(chord()); }
  SideShape reversed() const { return {last, first, -area}; }
};

/// On the side from which the chart is seen counter-clockwise; at a pole of the surface's parameters it is 0.
Vec3 normal_at(const Chart& chart, Vec3 x) {
  const auto nearest = std::min_element(chart.space_nodes.begin(), chart.space_nodes.end(),
                                        [x](Vec3 a, Vec3 b) { return norm2(a - x) < norm2(b - x); }) -
                       chart.space_nodes.begin();
  const std::size_t elem = nearest / chart.nodes_per_elem();
  const NurbsSurface& surface = chart.surfaces[chart.elem_surface[elem]];
  const SurfacePoint at = evaluate(surface, project(surface, x, chart.uv[nearest]).uv);
  const Vec3* const corners = &chart.space_nodes[elem * chart.nodes_per_elem()];
  const Vec3 normal = cross(at.xu, at.xv), of_elem = cross(corners[1] - corners[0], corners[2] - corners[0]);
  return dot(normal, of_elem) < 0 ? -normal : normal;
}

SideShape shape_of(const Chart& chart, const CurvesInSpace& curves) {
  static const spectral::Quadrature rule = spectral::gauss_legendre(16);
  const Vec3 first = chart.space_curves[curves.front()].poles.front(),
             last = chart.space_curves[curves.back()].poles.back();
  SideShape shape{{first, normal_at(chart, first)}, {last, normal_at(chart, last)}, {}};
  for (const int c : curves) {
    const SpaceCurve& curve = chart.space_curves[c];
    for (std::size_t k = 1; k < curve.knots.size(); ++k) {
      const double middle = (curve.knots[k - 1] + curve.knots[k]) / 2, half = curve.knots[k] - middle;
      for (std::size_t q = 0; half > 0 && q < rule.points.size(); ++q) {
        const auto at = derivatives(curve, middle + half * rule.points[q]);
        shape.area += rule.weights[q] * half / 2 * cross(at[0] - first, at[1]);
      }
    }
  }
  return shape;
}

using Columns = std::array<Vec3, 3>;

/// Orthonormal, the first along the chord, the third as near to `up` as possible.
Columns frame(Vec3 chord, Vec3 up) {
  const Vec3 along = normalized(chord), across = normalized(cross(up, along));
  return {along, across, cross(along, across)};
}

/// The frames of two sides that a motion maps onto each other.
std::array<Columns, 2> frames(const SideShape& a, const SideShape& b) {
  if (std::min(a.area_beside_chord(), b.area_beside_chord()) > least_area)
    return {frame(a.chord(), a.area), frame(b.chord(), b.area)};
  const auto smaller = [](Vec3 x, Vec3 y) { return std::min(norm2(x), norm2(y)); };
  if (smaller(a.first.normal, b.first.normal) >= smaller(a.last.normal, b.last.normal))
    return {frame(a.chord(), a.first.normal), frame(b.chord(), b.first.normal)};
  return {frame(a.chord(), a.last.normal), frame(b.chord(), b.last.normal)};
}

Vec3 without_rounding(Vec3 direction) {
  for (double* const x : {&direction.x, &direction.y, &direction.z})
    if (std::abs(*x) < tolerance::round_off) *x = 0;
  return normalized(direction);
}

}  // namespace

std::array<Vec3, 3> rotation_between(const std::array<Vec3, 3>& from, const std::array<Vec3, 3>& to) {
  std::array<Vec3, 3> rows{};
  for (int k = 0; k < 3; ++k) rows[0] += to[k].x * from[k], rows[1] += to[k].y * from[k], rows[2] += to[k].z * from[k];
  return rows;
}

std::array<Vec3, 3> rotation_about(const RotationAxis& axis) {
  const Vec3 d = axis.direction;
  const double c = std::cos(axis.angle), s = std::sin(axis.angle), r = 1 - c;
  return {Vec3{c + r * d.x * d.x, r * d.x * d.y - s * d.z, r * d.x * d.z + s * d.y},
          Vec3{r * d.y * d.x + s * d.z, c + r * d.y * d.y, r * d.y * d.z - s * d.x},
          Vec3{r * d.z * d.x - s * d.y, r * d.z * d.y + s * d.x, c + r * d.z * d.z}};
}

Vec3 image(const SpaceMotion& motion, Vec3 x) {
  const auto& m = motion.matrix;
  return Vec3{dot(m[0], x), dot(m[1], x), dot(m[2], x)} + motion.shift;
}

Vec3 original(const SpaceMotion& motion, Vec3 y) {
  const Vec3 d = y - motion.shift;
  return d.x * motion.matrix[0] + d.y * motion.matrix[1] + d.z * motion.matrix[2];
}

double snapped_to_fraction(double angle) {
  constexpr int most_parts = 720;
  for (int n = 1; n <= most_parts; ++n)
    if (const double whole = 2 * pi * std::round(angle * n / (2 * pi)) / n;
        std::abs(angle - whole) < tolerance::round_off)
      return whole;
  return angle;
}

RotationAxis rotation_axis(const SpaceMotion& motion) {
  const auto& [x, y, z] = motion.matrix;
  const Vec3 twice_sine{z.y - y.z, x.z - z.x, y.x - x.y};
  const double cosine = (x.x + y.y + z.z - 1) / 2, angle = std::atan2(norm(twice_sine) / 2, cosine);
  if (angle == 0) return {};
  if (cosine > -0.5) return {normalized(twice_sine), angle};
  // Near half a turn the symmetric part, (1 - cos) d d^T + cos, is the accurate one: its largest column.
  Columns columns{Vec3{x.x - cosine, (x.y + y.x) / 2, (x.z + z.x) / 2},
                  Vec3{(x.y + y.x) / 2, y.y - cosine, (y.z + z.y) / 2},
                  Vec3{(x.z + z.x) / 2, (y.z + z.y) / 2, z.z - cosine}};
  const Vec3 d = normalized(*std::ranges::max_element(columns, {}, [](Vec3 column) { return norm2(column); }));
  return {dot(d, twice_sine) < 0 ? -d : d, angle};
}

SpaceMotion motion_between(const Chart& chart, const CurvesInSpace& first, const CurvesInSpace& second) {
  const SideShape from = shape_of(chart, first), to = shape_of(chart, second).reversed();
  SpaceMotion motion;
  const auto [frame, image_of_frame] = frames(from, to);
  motion.matrix = rotation_between(frame, image_of_frame);
  RotationAxis axis = rotation_axis(motion);
  axis.angle = snapped_to_fraction(axis.angle);
  motion.matrix = SpaceMotion().matrix;
  if (axis.angle != 0) {
    axis.direction = without_rounding(axis.direction);
    motion.matrix = rotation_about(axis);
  }
  const Vec3 middle = (from.first.position + from.last.position) / 2;
  motion.shift = (to.first.position + to.last.position) / 2 - image(motion, middle);
  return motion;
}

SpaceMotion periodic_motion(const CadFace& face, const PeriodicPair& pair) {
  return motion_between(*face.chart, {pair.curves[0]}, {pair.curves[1]});
}

}  // namespace quadrille::surface
