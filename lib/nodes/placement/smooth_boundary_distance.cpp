#include "placement/smooth_boundary_distance.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/gauss.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::placement {
namespace {

constexpr int max_depth = 50;

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
class InteriorMeasure : public SmoothBoundaryDistance {
 public:
  InteriorMeasure(const CadFace& face, std::optional<Axis> axis) : SmoothBoundaryDistance(face), axis_(axis) {}

  double value(Vec2 x) const {
    Vec2 ignored;
    return log_smooth(x, ignored);
  }
  Vec2 gradient(Vec2 x) const {
    Vec2 g;
    log_smooth(x, g);
    return axis_ ? dot(g, axis_->direction) * axis_->direction : g;
  }
  Vec2 onto_fixed(Vec2 x) const {
    return axis_ ? axis_->origin + dot(x - axis_->origin, axis_->direction) * axis_->direction : x;
  }

 private:
  std::optional<Axis> axis_;
};

std::optional<Vec2> best_of_grid(const InteriorMeasure& measure, int steps) {
  const CadFace& face = measure.face();
  std::optional<Vec2> best;
  double most = 0;
  for (int i = -steps; i <= steps; ++i)
    for (int j = -steps; j <= steps; ++j) {
      const Vec2 offset = face.diameter / steps * Vec2{i + 0.41, j + 0.43};
      const Vec2 x = measure.onto_fixed(face.joints[0].position + offset);
      if (measure.signed_distance(x) < 1e-3 * face.diameter) continue;
      const double here = measure.value(x);
      if (!best || here > most) best = x, most = here;
    }
  return best;
}

/// The starting point: because the measure is smooth, the grid is refined only until one of its points lies in the
/// face.
Vec2 interior_start(const InteriorMeasure& measure) {
  for (int steps = 12; steps <= 192; steps *= 2)
    if (const auto best = best_of_grid(measure, steps)) return *best;
  throw ComputeError("the face has no point farther than a thousandth of its diameter from its boundary");
}

/// Steepest ascent with halved steps, then Newton's method with differences of the gradient.
Vec2 ascended(const InteriorMeasure& measure, Vec2 x) {
  const double diameter = measure.face().diameter;
  for (int iteration = 0; iteration < 60; ++iteration) {
    const Vec2 g = measure.gradient(x);
    const double h = 1e-5 * diameter;
    const Vec2 gx = (measure.gradient(x + Vec2{h, 0}) - measure.gradient(x - Vec2{h, 0})) / (2 * h);
    const Vec2 gy = (measure.gradient(x + Vec2{0, h}) - measure.gradient(x - Vec2{0, h})) / (2 * h);
    // On an axis the Hessian is singular across it: a small shift keeps the step on the axis.
    const double shift = 1e-9 * (std::abs(gx.x) + std::abs(gy.y));
    const Mat2 hessian{gx.x - shift, gy.x, gx.y, gy.y - shift};
    Vec2 step = measure.onto_fixed(x - inverse(hessian) * g) - x;
    if (norm(step) < 1e-7 * diameter) {
      x += step;
      if (norm(step) < 1e-13 * diameter) break;
      continue;
    }
    if (dot(step, g) <= 0) step = 0.2 * measure.signed_distance(x) * normalized(g);
    const double before = measure.value(x);
    const auto is_worse = [&](Vec2 y) { return measure.signed_distance(y) <= 0 || measure.value(y) < before; };
    while (norm(step) > 1e-7 * diameter && is_worse(x + step)) step *= 0.5;
    x += step;
  }
  return x;
}

}  // namespace

/// The integrals oint ds / r^2 and oint (y - x) ds / r^4.
struct SmoothBoundaryDistance::Integral {
  double value = 0;
  Vec2 moment;
};

SmoothBoundaryDistance::SmoothBoundaryDistance(const CadFace& face) : FaceBoundary(face) {
  for (int c = 0; c < face.num_curves(); ++c) {
    const std::vector<double>& knots = face.curves[c].knots;
    for (std::size_t i = 1; i < knots.size(); ++i)
      if (knots[i - 1] < knots[i]) cut(c, knots[i - 1], knots[i], 0);
  }
}

SmoothBoundaryDistance::Piece SmoothBoundaryDistance::piece(int curve, double t0, double t1) const {
  const curve::GaussRule<16>& rule = curve::gauss_rule<16>();
  const Nurbs& nurbs = face().curves[curve];
  const double middle = (t0 + t1) / 2, half = (t1 - t0) / 2;
  Piece piece{curve, t0, t1, 0, {}, {}};
  for (int i = 0; i < 16; ++i) {
    const double t = middle + half * rule.points[i];
    piece.points[i] = curve::point(nurbs, t);
    piece.weights[i] = half * rule.weights[i] * norm(curve::derivative(nurbs, t));
    piece.length += piece.weights[i];
  }
  return piece;
}

// Cuts until the speed is smooth enough for the rule and nearly constant, so that lengths determine the positions of
// the points.
void SmoothBoundaryDistance::cut(int curve, double t0, double t1, int depth) {
  const Piece whole = piece(curve, t0, t1);
  const double middle = (t0 + t1) / 2;
  const double left = piece(curve, t0, middle).length, right = piece(curve, middle, t1).length;
  const double noise = 2e-15 * face().diameter;  // of differences of poles
  const bool is_exact = std::abs(left + right - whole.length) <= 1e-14 * whole.length + noise;
  const bool is_even = std::max(left, right) <= 2 * std::min(left, right);
  if ((is_exact && is_even) || depth >= max_depth || whole.length <= 1e-12 * face().diameter) {
    pieces_.push_back(whole);
  } else {
    cut(curve, t0, middle, depth + 1);
    cut(curve, middle, t1, depth + 1);
  }
}

// 1 / r^2 has its poles at the distance of x from the piece: if this is at least the piece's length, 16 points are
// exact.
void SmoothBoundaryDistance::add(const Piece& whole, Vec2 x, int depth, Integral& sum) const {
  double least2 = HUGE_VAL;
  for (const Vec2 y : whole.points) least2 = std::min(least2, norm2(x - y));
  if (whole.length > std::sqrt(least2) && depth < max_depth) {
    const double middle = (whole.t0 + whole.t1) / 2;
    add(piece(whole.curve, whole.t0, middle), x, depth + 1, sum);
    add(piece(whole.curve, middle, whole.t1), x, depth + 1, sum);
    return;
  }
  for (int i = 0; i < 16; ++i) {
    const Vec2 r = whole.points[i] - x;
    const double r2 = norm2(r), part = whole.weights[i] / r2;
    sum.value += part;
    sum.moment += part / r2 * r;
  }
}

double SmoothBoundaryDistance::log_smooth(Vec2 x, Vec2& gradient) const {
  Integral sum;
  for (const Piece& whole : pieces_) add(whole, x, 0, sum);
  gradient = (-2 / sum.value) * sum.moment;
  return std::log(pi / sum.value);
}

Vec2 most_interior_point(const CadFace& face, const std::vector<curve::Isometry>& group) {
  const InteriorMeasure measure(face, mirror_axis(group));
  return ascended(measure, interior_start(measure));
}

}  // namespace quadrille::placement
