#include "zeros/enclosure.hpp"

#include <algorithm>

#include "base/angle.hpp"
#include "field/explicit_value.hpp"
#include "spectral/tri_bernstein.hpp"

namespace quadrille::zeros {
namespace {

struct Angles {
  double low = 0, high = 0;
};

/// The angles at which `eye` sees the cell, counted from the direction to `centre`: the angles of the Bernstein points,
/// whose hull contains the cell, or of the vertices of a straight one. The whole circle if the points are not on one
/// side of `eye`.
Angles viewing_angles(const Cell& cell, Vec2 eye, Vec2 centre) {
  const Vec2 ahead = centre - eye;
  Angles angles;
  for (int i = 0; i < (cell.is_straight ? 3 : cell.num_coefs()); ++i) {
    const Vec2 d = (cell.is_straight ? cell.vertex(i) : cell.point(i)) - eye;
    if (norm2(d) <= 1e-24 * norm2(ahead)) continue;  // the eye itself is a vertex
    if (dot(ahead, d) <= 0) return {-pi, pi};
    const double angle = std::atan2(cross(ahead, d), dot(ahead, d));
    angles = {std::min(angles.low, angle), std::max(angles.high, angle)};
  }
  return angles;
}

}  // namespace

void Enclosure::set(const Cell& cell, const std::vector<Lifting>& liftings, double margin) {
  set_polynomial(cell, margin);
  Vec2 shift;
  Mat2 slope;
  double size = 0, rounding = 0;
  add_liftings(liftings, shift, slope, size, rounding);
  finish(shift, slope, size, rounding);
}

void Enclosure::set(const Cell& cell, const Field& field, const LiftingGroup& group, double margin) {
  if (group.jumps == 0) return set(cell, group.near_liftings, margin);
  set_polynomial(cell, margin);
  if (!group.contains(centre_, radius_)) return set(cell, field.liftings, margin);
  Mat2 slope;
  Vec2 shift = group.far_sum(centre_, slope);
  double size = group.jumps, rounding = group.rounding;
  far_rest_ = 0.5 * group.bend * radius_ * radius_;
  gradient_error_ = group.bend * radius_;
  add_liftings(group.near_liftings, shift, slope, size, rounding);
  finish(shift, slope, size, rounding);
}

void Enclosure::set_polynomial(const Cell& cell, double margin) {
  cell_ = &cell;
  margin_ = margin;
  centre_ = (cell.vertex(0) + cell.vertex(1) + cell.vertex(2)) / 3;
  double radius2 = 0;
  values_.resize(cell.num_coefs());
  for (int i = 0; i < cell.num_coefs(); ++i) {
    values_[i] = cell.value(i);
    radius2 = std::max(radius2, norm2(cell.point(i) - centre_));
  }
  radius_ = std::sqrt(radius2);
  ranges_.clear();
  far_rest_ = gradient_error_ = 0;
}

void Enclosure::add_liftings(const std::vector<Lifting>& liftings, Vec2& shift, Mat2& slope, double& size,
                             double& rounding) {
  for (const Lifting& lifting : liftings) {
    const double to_apex = distance(lifting.apex, centre_), to_pole = distance(lifting.pole, centre_);
    size += norm(lifting.jump);
    rounding += norm(lifting.jump) * (1 / std::max(to_apex, radius_) + 1 / std::max(to_pole, radius_));
    if (std::min(to_apex, to_pole) > 2 * radius_)
      add_linearised(lifting, shift, slope);
    else
      add_by_angles(lifting);
  }
}

void Enclosure::finish(Vec2 shift, const Mat2& slope, double size, double rounding) {
  double size2 = 0;
  for (int i = 0; i < cell_->num_coefs(); ++i) {
    size2 = std::max(size2, norm2(cell_->value(i)));
    values_[i] += shift + slope * (cell_->point(i) - centre_);
  }
  // A position is rounded relative to its distance from the origin, which rotates the lifting's angle close to a
  // corner.
  slack_ = 1e-14 * (size + std::sqrt(size2)) + 1e-15 * cell_->scale + 4e-16 * (norm(centre_) + radius_) * rounding;
}

void Enclosure::add_linearised(const Lifting& lifting, Vec2& shift, Mat2& slope) {
  const Vec2 gradient = field::lifting_gradient(lifting, centre_), jump = lifting.jump;
  shift += field::lifting_angle(lifting, centre_) * jump;
  slope = {slope.xx + jump.x * gradient.x, slope.xy + jump.x * gradient.y, slope.yx + jump.y * gradient.x,
           slope.yy + jump.y * gradient.y};
  const double near_apex = distance(lifting.apex, centre_) - radius_;
  const double near_pole = distance(lifting.pole, centre_) - radius_;
  const double bend = 1 / (near_apex * near_apex) + 1 / (near_pole * near_pole);
  ranges_.push_back({lifting.jump, 0.5 * bend * radius_ * radius_});
  gradient_error_ += norm(lifting.jump) * bend * radius_;
}

void Enclosure::add_by_angles(const Lifting& lifting) {
  const Angles apex = viewing_angles(*cell_, lifting.apex, centre_);
  const Angles pole = viewing_angles(*cell_, lifting.pole, centre_);
  const double low = apex.low - pole.high, high = apex.high - pole.low;
  const Vec2 middle = lifting.jump * (field::lifting_angle(lifting, centre_) + 0.5 * (low + high));
  for (Vec2& value : values_) value += middle;
  ranges_.push_back({lifting.jump, 0.5 * (high - low)});
  gradient_error_ = INFINITY;
}

/// The least value of direction . v over all contributions of the ranges.
double Enclosure::support(Vec2 direction) const {
  double sum = far_rest_;
  for (const Range& range : ranges_) sum += std::abs(dot(direction, range.jump)) * range.half_width;
  return -sum;
}

/// Whether 0 lies in the hull of the values, even without the ranges. False in doubt.
bool Enclosure::surrounds_zero() const {
  Vec2 right = values_.front(), left = right;  // the directions seen are between these
  for (const Vec2 value : values_) {
    const bool is_right = cross(right, value) < 0;
    const bool is_left = cross(left, value) > 0;
    if (is_right && is_left) return true;
    if (is_right) right = value;
    if (is_left) left = value;
  }
  return false;
}

/// The greatest distance found of a half plane that contains all values from 0, less slack and margin; looks until it
/// is this part of the greatest possible. Not positive: none was found that does not contain 0.
double Enclosure::separation(double part_of_greatest) const {
  if (surrounds_zero()) return 0;
  // y runs towards the point of the hull nearest to 0; the half planes are normal to y.
  double greatest = 0;
  Vec2 y;
  for (const Vec2 value : values_) y += value;
  y = y / static_cast<double>(values_.size());
  for (int step = 0; step < 12; ++step) {
    const double length = norm(y);
    if (length <= slack_ + margin_) break;
    const Vec2 direction = y / length;
    double least = INFINITY;
    Vec2 nearest;
    for (const Vec2 value : values_) {
      const double d = dot(direction, value);
      if (d < least) least = d, nearest = value;
    }
    greatest = std::max(greatest, least + support(direction) - (slack_ + margin_));
    if (greatest > part_of_greatest * length) break;
    // The extreme point of the hull widened by the ranges.
    for (const Range& range : ranges_) {
      const double side = dot(direction, range.jump) > 0 ? -1 : 1;
      nearest += range.jump * (side * range.half_width);
    }
    nearest -= far_rest_ * direction;
    const Vec2 chord = nearest - y;
    const double part = -dot(y, chord) / norm2(chord);
    if (!(part > 0)) break;
    y += std::min(part, 1.0) * chord;
  }
  return greatest;
}

bool Enclosure::isolates(Mat2& inverse_jacobian, double& contraction) const {
  if (gradient_error_ == INFINITY) return false;
  const int n = cell_->degree;
  const auto derivative = [&](int j, int k) {
    const Vec2 base = values_[spectral::bernstein_index(n, j, k)];
    const Vec2 d1 = values_[spectral::bernstein_index(n, j + 1, k)] - base,
               d2 = values_[spectral::bernstein_index(n, j, k + 1)] - base;
    return Mat2{n * d1.x, n * d2.x, n * d1.y, n * d2.y};
  };
  Mat2 mean;
  double stretch = 0;  // greatest |d x / d lambda|
  for (int k = 0; k < n; ++k)
    for (int j = 0; j + k < n; ++j) {
      const Mat2 d = derivative(j, k);
      mean = {mean.xx + d.xx, mean.xy + d.xy, mean.yx + d.yx, mean.yy + d.yy};
      const Vec2 base = cell_->point(spectral::bernstein_index(n, j, k));
      stretch = std::max(stretch, norm2(cell_->point(spectral::bernstein_index(n, j + 1, k)) - base) +
                                      norm2(cell_->point(spectral::bernstein_index(n, j, k + 1)) - base));
    }
  const double count = spectral::num_bernstein(n - 1);
  mean = {mean.xx / count, mean.xy / count, mean.yx / count, mean.yy / count};
  if (!(std::abs(det(mean)) > 1e-14 * frobenius_norm(mean) * frobenius_norm(mean))) return false;
  inverse_jacobian = inverse(mean);
  contraction = 0;
  for (int k = 0; k < n; ++k)
    for (int j = 0; j + k < n; ++j) {
      const Mat2 m = inverse_jacobian * derivative(j, k);
      contraction = std::max(contraction, frobenius_norm({m.xx - 1, m.xy, m.yx, m.yy - 1}));
    }
  contraction += frobenius_norm(inverse_jacobian) * (gradient_error_ * n * std::sqrt(stretch) + 2 * n * slack_);
  return contraction < 0.75;
}

double Enclosure::greatest_value() const {
  double greatest2 = 0;
  for (const Vec2 value : values_) greatest2 = std::max(greatest2, norm2(value));
  double greatest = std::sqrt(greatest2);
  for (const Range& range : ranges_) greatest += norm(range.jump) * range.half_width;
  return greatest + far_rest_;
}

}  // namespace quadrille::zeros
