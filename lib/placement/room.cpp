#include "placement/room.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"
#include "curve/project.hpp"
#include "placement/wall_distance.hpp"

namespace quadrille::placement {
namespace {

/// By the side of the boundary at the nearest point; at a joint by its sector.
bool is_inside(const CadFace& face, const BoundaryFoot& foot, Vec2 x) {
  const Nurbs& curve = face.curves[foot.curve];
  const double end_tol = 1e-9 * (curve.end() - curve.begin());
  const bool at_begin = foot.t <= curve.begin() + end_tol, at_end = foot.t >= curve.end() - end_tol;
  if (!at_begin && !at_end) return cross(curve::tangent(curve, foot.t), x - foot.position) > 0;
  const Joint& joint = face.joints[at_begin ? foot.curve : face.next_in_loop(foot.curve)];
  return wrap_two_pi(angle_of(x - joint.position) - joint.tangent_out) < joint.interior_angle;
}

/// Where the ray meets the curve: signs of the side at steps along it, halved.
void add_hits(const Nurbs& curve, Vec2 x, Vec2 direction, std::vector<double>& hits) {
  constexpr int steps = 32;
  const auto side = [&](double t) { return cross(direction, curve::point(curve, t) - x) > 0; };
  for (std::size_t k = 1; k < curve.knots.size(); ++k) {
    const double t0 = curve.knots[k - 1], t1 = curve.knots[k];
    for (int i = 0; i < steps && t0 < t1; ++i) {
      double a = t0 + (t1 - t0) * i / steps, b = i + 1 == steps ? t1 : t0 + (t1 - t0) * (i + 1) / steps;
      const bool before = side(a);
      if (side(b) == before) continue;
      for (int halving = 0; halving < 60; ++halving) {
        const double middle = (a + b) / 2;
        (side(middle) == before ? a : b) = middle;
      }
      const double along = dot(curve::point(curve, (a + b) / 2) - x, direction);
      if (along > 0) hits.push_back(along);
    }
  }
}

/// Points that a group leaves where they are: a line x0 + s d, or all of the plane.
struct Axis {
  Vec2 origin, direction;
};

std::optional<Axis> mirror_axis(const std::vector<curve::Isometry>& group) {
  for (const curve::Isometry& g : group)
    if (g.is_mirrored) return Axis{g.centre, unit(g.angle / 2)};
  return {};
}

/// ln delta restricted to the fixed points; its gradient lies in them.
class InteriorMeasure {
 public:
  InteriorMeasure(const CadFace& face, std::optional<Axis> axis) : walls_(face), axis_(axis) {}

  double value(Vec2 x) const {
    Vec2 ignored;
    return walls_.log_smooth(x, ignored);
  }
  Vec2 gradient(Vec2 x) const {
    Vec2 g;
    walls_.log_smooth(x, g);
    return axis_ ? dot(g, axis_->direction) * axis_->direction : g;
  }
  Vec2 onto_fixed(Vec2 x) const {
    return axis_ ? axis_->origin + dot(x - axis_->origin, axis_->direction) * axis_->direction : x;
  }

 private:
  WallDistance walls_;
  std::optional<Axis> axis_;
};

std::optional<Vec2> best_of_grid(const CadFace& face, const InteriorMeasure& measure, int steps) {
  std::optional<Vec2> best;
  double most = 0;
  for (int i = -steps; i <= steps; ++i)
    for (int j = -steps; j <= steps; ++j) {
      const Vec2 offset = face.diameter / steps * Vec2{i + 0.41, j + 0.43};
      const Vec2 x = measure.onto_fixed(face.joints[0].position + offset);
      if (signed_room(face, x) < 1e-3 * face.diameter) continue;
      const double here = measure.value(x);
      if (!best || here > most) best = x, most = here;
    }
  return best;
}

/// Where to begin: the measure is smooth, so the grid is refined only until it meets the face.
Vec2 interior_start(const CadFace& face, const InteriorMeasure& measure) {
  for (int steps = 12; steps <= 192; steps *= 2)
    if (const auto best = best_of_grid(face, measure, steps)) return *best;
  throw ComputeError("the face has no point farther than a thousandth of its diameter from its boundary");
}

/// Steepest ascent with halved steps, then Newton with differences of the gradient.
Vec2 ascended(const CadFace& face, const InteriorMeasure& measure, Vec2 x) {
  for (int iteration = 0; iteration < 60; ++iteration) {
    const Vec2 g = measure.gradient(x);
    const double h = 1e-5 * face.diameter;
    const Vec2 gx = (measure.gradient(x + Vec2{h, 0}) - measure.gradient(x - Vec2{h, 0})) / (2 * h);
    const Vec2 gy = (measure.gradient(x + Vec2{0, h}) - measure.gradient(x - Vec2{0, h})) / (2 * h);
    // On an axis the Hessian is singular across it: a small shift makes the step the axis's own.
    const double shift = 1e-9 * (std::abs(gx.x) + std::abs(gy.y));
    const Mat2 hessian{gx.x - shift, gy.x, gx.y, gy.y - shift};
    Vec2 step = measure.onto_fixed(x - inverse(hessian) * g) - x;
    if (norm(step) < 1e-7 * face.diameter) {
      x += step;
      if (norm(step) < 1e-13 * face.diameter) break;
      continue;
    }
    if (dot(step, g) <= 0) step = 0.2 * signed_room(face, x) * normalized(g);
    const double before = measure.value(x);
    const auto is_worse = [&](Vec2 y) { return signed_room(face, y) <= 0 || measure.value(y) < before; };
    while (norm(step) > 1e-7 * face.diameter && is_worse(x + step)) step *= 0.5;
    x += step;
  }
  return x;
}

}  // namespace

std::vector<BoundaryFoot> nearest_feet(const CadFace& face, Vec2 x) {
  std::vector<BoundaryFoot> feet;
  double least = INFINITY;
  for (int c = 0; c < face.num_curves(); ++c) {
    const curve::Projection p = curve::project(face.curves[c], x);
    feet.push_back({c, p.t, p.position, p.distance});
    least = std::min(least, p.distance);
  }
  std::erase_if(feet, [&](const BoundaryFoot& foot) { return foot.distance > least + 1e-6 * face.diameter; });
  return feet;
}

double signed_room(const CadFace& face, Vec2 x) {
  const std::vector<BoundaryFoot> feet = nearest_feet(face, x);
  const auto nearest = std::min_element(
      feet.begin(), feet.end(), [](const BoundaryFoot& a, const BoundaryFoot& b) { return a.distance < b.distance; });
  return is_inside(face, *nearest, x) ? nearest->distance : -nearest->distance;
}

double room_along(const CadFace& face, Vec2 x, Vec2 direction) {
  std::vector<double> hits{0};
  for (const Nurbs& curve : face.curves) add_hits(curve, x, direction, hits);
  std::sort(hits.begin(), hits.end());
  for (std::size_t i = 1; i < hits.size(); ++i)
    if (signed_room(face, x + (hits[i - 1] + hits[i]) / 2 * direction) > 0) return hits[i] - hits[i - 1];
  return 0;
}

Vec2 most_interior_point(const CadFace& face, const std::vector<curve::Isometry>& group) {
  const InteriorMeasure measure(face, mirror_axis(group));
  return ascended(face, measure, interior_start(face, measure));
}

}  // namespace quadrille::placement
