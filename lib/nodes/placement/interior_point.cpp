#include "placement/interior_point.hpp"

#include <cmath>
#include <optional>

#include "base/error.hpp"
#include "placement/clearance.hpp"
#include "placement/smooth_boundary_distance.hpp"

namespace quadrille::placement {
namespace {

/// The points that are invariant under a group: a line x0 + s d.
struct Axis {
  Vec2 origin, direction;
};

std::optional<Axis> mirror_axis(const std::vector<curve::Isometry>& group) {
  for (const curve::Isometry& g : group)
    if (g.is_mirrored) return Axis{g.centre, unit(g.angle / 2)};
  return {};
}

/// ln delta restricted to the invariant points, with its gradient projected onto them.
class InteriorMeasure {
 public:
  InteriorMeasure(const CadFace& face, std::optional<Axis> axis) : boundary_(face), axis_(axis) {}

  double value(Vec2 x) const {
    Vec2 ignored;
    return boundary_.log_smooth(x, ignored);
  }
  Vec2 gradient(Vec2 x) const {
    Vec2 g;
    boundary_.log_smooth(x, g);
    return axis_ ? dot(g, axis_->direction) * axis_->direction : g;
  }
  Vec2 onto_fixed(Vec2 x) const {
    return axis_ ? axis_->origin + dot(x - axis_->origin, axis_->direction) * axis_->direction : x;
  }

 private:
  SmoothBoundaryDistance boundary_;
  std::optional<Axis> axis_;
};

std::optional<Vec2> best_of_grid(const CadFace& face, const InteriorMeasure& measure, int steps) {
  std::optional<Vec2> best;
  double most = 0;
  for (int i = -steps; i <= steps; ++i)
    for (int j = -steps; j <= steps; ++j) {
      const Vec2 offset = face.diameter / steps * Vec2{i + 0.41, j + 0.43};
      const Vec2 x = measure.onto_fixed(face.joints[0].position + offset);
      if (signed_clearance(face, x) < 1e-3 * face.diameter) continue;
      const double here = measure.value(x);
      if (!best || here > most) best = x, most = here;
    }
  return best;
}

/// The starting point: because the measure is smooth, the grid is refined only until one of its points lies in the
/// face.
Vec2 interior_start(const CadFace& face, const InteriorMeasure& measure) {
  for (int steps = 12; steps <= 192; steps *= 2)
    if (const auto best = best_of_grid(face, measure, steps)) return *best;
  throw ComputeError("the face has no point farther than a thousandth of its diameter from its boundary");
}

/// Steepest ascent with halved steps, then Newton's method with differences of the gradient.
Vec2 ascended(const CadFace& face, const InteriorMeasure& measure, Vec2 x) {
  for (int iteration = 0; iteration < 60; ++iteration) {
    const Vec2 g = measure.gradient(x);
    const double h = 1e-5 * face.diameter;
    const Vec2 gx = (measure.gradient(x + Vec2{h, 0}) - measure.gradient(x - Vec2{h, 0})) / (2 * h);
    const Vec2 gy = (measure.gradient(x + Vec2{0, h}) - measure.gradient(x - Vec2{0, h})) / (2 * h);
    // On an axis the Hessian is singular across it: a small shift keeps the step on the axis.
    const double shift = 1e-9 * (std::abs(gx.x) + std::abs(gy.y));
    const Mat2 hessian{gx.x - shift, gy.x, gx.y, gy.y - shift};
    Vec2 step = measure.onto_fixed(x - inverse(hessian) * g) - x;
    if (norm(step) < 1e-7 * face.diameter) {
      x += step;
      if (norm(step) < 1e-13 * face.diameter) break;
      continue;
    }
    if (dot(step, g) <= 0) step = 0.2 * signed_clearance(face, x) * normalized(g);
    const double before = measure.value(x);
    const auto is_worse = [&](Vec2 y) { return signed_clearance(face, y) <= 0 || measure.value(y) < before; };
    while (norm(step) > 1e-7 * face.diameter && is_worse(x + step)) step *= 0.5;
    x += step;
  }
  return x;
}

}  // namespace

Vec2 most_interior_point(const CadFace& face, const std::vector<curve::Isometry>& group) {
  const InteriorMeasure measure(face, mirror_axis(group));
  return ascended(face, measure, interior_start(face, measure));
}

}  // namespace quadrille::placement
