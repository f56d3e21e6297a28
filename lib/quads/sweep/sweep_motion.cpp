#include "sweep/sweep_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/angle.hpp"

namespace quadrille::sweep {

namespace {

constexpr int steps_per_span = 64;  ///< of parallel transport, whose error falls with the fourth power
constexpr int length_samples = 32;  ///< per span

SpaceMotion about(const std::array<Vec3, 3>& matrix, Vec3 centre) {
  SpaceMotion motion{matrix, {}};
  motion.shift = centre - image(motion, centre);
  return motion;
}

/// A unit vector normal to a unit vector.
Vec3 any_normal(Vec3 t) {
  const double x = std::abs(t.x), y = std::abs(t.y), z = std::abs(t.z);
  const Vec3 least = x <= y && x <= z ? Vec3{1, 0, 0} : y <= z ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
  return normalized(cross(t, least));
}

Vec3 reflected(Vec3 v, Vec3 normal) { return v - 2 * dot(v, normal) / norm2(normal) * normal; }

/// `carried`, normal to the tangent at u0, at u1: reflected in the bisecting plane of both points, then in that of the
/// reflected tangent and the one there.
Vec3 transported(const SpaceSpline& spline, double u0, double u1, Vec3 carried) {
  const Vec3 chord = spline.at(u1) - spline.at(u0);
  if (!(norm2(chord) > 0)) return carried;
  const Vec3 tangent = reflected(normalized(spline.derivative(u0)), chord);
  const Vec3 turn = normalized(spline.derivative(u1)) - tangent;
  const Vec3 once = reflected(carried, chord);
  return norm2(turn) > 0 ? reflected(once, turn) : once;
}

double step_end(const SpaceSpline& spline, int step) {
  const int span = std::min(step / steps_per_span, spline.num_spans() - 1);
  const double part = static_cast<double>(step - span * steps_per_span) / steps_per_span;
  return spline.knot(span) + part * (spline.knot(span + 1) - spline.knot(span));
}

/// Columns: the carried normal, the other one, the tangent.
std::array<Vec3, 3> frame(const SpaceSpline& spline, double u, Vec3 normal) {
  const Vec3 tangent = normalized(spline.derivative(u));
  return {normal, cross(tangent, normal), tangent};
}

}  // namespace

SpaceMotion combined(const SpaceMotion& first, const SpaceMotion& second) {
  SpaceMotion both;
  for (int r = 0; r < 3; ++r) {
    const Vec3& row = second.matrix[r];
    both.matrix[r] = row.x * first.matrix[0] + row.y * first.matrix[1] + row.z * first.matrix[2];
  }
  both.shift = image(second, first.shift);
  return both;
}

SpaceMotion rotation(const Axis& axis, double angle) {
  return about(surface::rotation_about({axis.direction, angle}), axis.point);
}

SweepMotion::SweepMotion(SweepShape shape) : shape_(std::move(shape)) {
  if (shape_.curve.empty()) return;
  spline_.emplace(shape_.curve);
  normals_.push_back(any_normal(normalized(spline_->derivative(0))));
  for (int step = 0; step < spline_->num_spans() * steps_per_span; ++step)
    normals_.push_back(transported(*spline_, step_end(*spline_, step), step_end(*spline_, step + 1), normals_.back()));
}

double SweepMotion::length() const {
  if (!spline_) return norm(shape_.along);
  double sum = 0;
  for (int span = 0; span < spline_->num_spans(); ++span)
    for (int k = 0; k < length_samples; ++k) {
      const double h = spline_->knot(span + 1) - spline_->knot(span);
      sum += h / length_samples * norm(spline_->derivative(spline_->knot(span) + h * (k + 0.5) / length_samples));
    }
  return sum;
}

bool SweepMotion::is_closed() const {
  return shape_.axis && shape_.twist == 0 && shape_.taper == 1 && std::abs(std::abs(shape_.angle) - 2 * pi) <= 1e-12;
}

SpaceMotion SweepMotion::in_plane(double s) const {
  if (shape_.twist == 0 && shape_.taper == 1) return {};
  SpaceMotion motion = rotation({shape_.centre, shape_.normal}, s * shape_.twist);
  const double scale = 1 + s * (shape_.taper - 1);
  for (Vec3& row : motion.matrix) row = scale * row;
  return about(motion.matrix, shape_.centre);
}

SpaceMotion SweepMotion::along_curve(double s) const {
  const auto above = [&](int step) { return step_end(*spline_, step) <= s; };
  int step = 0;  // the last one that ends at or before s
  for (int width = static_cast<int>(normals_.size()); width > 0; width /= 2)
    while (step + width < static_cast<int>(normals_.size()) && above(step + width)) step += width;
  const Vec3 normal = transported(*spline_, step_end(*spline_, step), s, normals_[step]);
  SpaceMotion motion{surface::rotation_between(frame(*spline_, 0, normals_[0]), frame(*spline_, s, normal)), {}};
  motion.shift = spline_->at(s) - image(motion, spline_->at(0));
  return motion;
}

SpaceMotion SweepMotion::at(double s) const {
  if (s == 0) return {};
  const SpaceMotion in_face = in_plane(s);
  if (shape_.axis) return combined(in_face, rotation(*shape_.axis, s * shape_.angle));
  if (spline_) return combined(in_face, along_curve(s));
  SpaceMotion motion = in_face;
  motion.shift += s * shape_.along;
  return motion;
}

}  // namespace quadrille::sweep
