#include "zeros/far_liftings.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "curve/pole_box.hpp"
#include "field/explicit_value.hpp"
#include "spectral/orthogonal_basis.hpp"

namespace quadrille::zeros {
namespace {

constexpr std::size_t least_liftings = 64;  // with fewer, series save nothing
constexpr int elements_per_group = 16;
constexpr double least_distance = 3;  // of far liftings, in radii
constexpr double remainder = 1e-17;   // of a series

// The principal value of theta_c jumps across the segment from the apex to the pole.
bool is_far(const Lifting& lifting, Vec2 centre, double radius) {
  const Vec2 along = lifting.pole - lifting.apex;
  const double length2 = norm2(along);
  const double f = length2 > 0 ? std::clamp(dot(centre - lifting.apex, along) / length2, 0.0, 1.0) : 0.0;
  return distance(lifting.apex + f * along, centre) >= least_distance * radius;
}

std::vector<Vec2> jumps_of(const Field& field) {
  std::vector<Vec2> jumps;
  for (const Lifting& lifting : field.liftings) jumps.push_back(lifting.jump);
  return jumps;
}

void add_series(Vec2 d, Vec2 jump, LiftingGroup& group) {
  const Vec2 q = (group.radius / norm2(d)) * Vec2{d.x, -d.y};
  Vec2 power = q;
  for (std::size_t k = 1; norm2(power) > remainder * remainder; ++k, power = field::product(power, q)) {
    if (group.u.size() < k) group.u.emplace_back(), group.v.emplace_back();
    group.u[k - 1] += (-jump.x / static_cast<double>(k)) * power;
    group.v[k - 1] += (-jump.y / static_cast<double>(k)) * power;
  }
}

// Im f(t) for f with these coefficients of t, t^2, ..., and d f / d t.
double value_at(const std::vector<Vec2>& series, Vec2 t, Vec2& derivative) {
  Vec2 f;
  derivative = {};
  for (std::size_t k = series.size(); k-- > 0;) {
    derivative = field::product(derivative, t) + f;
    f = field::product(f, t) + series[k];
  }
  derivative = field::product(derivative, t) + f;
  return field::product(f, t).y;
}

}  // namespace

Vec2 LiftingGroup::far_sum(Vec2 x, Mat2& gradient) const {
  const Vec2 t = (x - centre) / radius;
  Vec2 du, dv;
  const Vec2 sum{value_at(u, t, du), value_at(v, t, dv)};
  gradient = {gradient.xx + du.y / radius, gradient.xy + du.x / radius, gradient.yx + dv.y / radius,
              gradient.yy + dv.x / radius};
  return at_centre + sum;
}

FarLiftings::FarLiftings(const field::FieldEvaluator& evaluator) : evaluator_(&evaluator) {
  if (evaluator.field().liftings.size() >= least_liftings) {
    group_elements();
  } else {
    groups_.emplace_back().radius = INFINITY;  // all are near
    elem2group_.assign(evaluator.maps().size(), 0);
  }
  group2jumps_.resize(groups_.size());
  is_current_.assign(groups_.size(), false);
  jumps_ = jumps_of(evaluator.field());
}

void FarLiftings::group_elements() {
  std::vector<Vec2> centres;
  for (const spectral::TriMap& map : evaluator_->maps()) centres.push_back(map.position(field::centroid));
  curve::PoleBox box{centres.front(), centres.front()};
  for (const Vec2 x : centres) box.extend({x, x});
  const auto& [low, high] = box;
  const int n = 1 + static_cast<int>(std::sqrt(static_cast<double>(centres.size()) / elements_per_group));
  const double side = std::max(high.x - low.x, high.y - low.y) / n;
  const auto cell = [&](double offset) { return side > 0 ? std::min(static_cast<int>(offset / side), n - 1) : 0; };
  groups_.resize(static_cast<std::size_t>(n) * n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) groups_[i + n * j].centre = low + side * Vec2{i + 0.5, j + 0.5};
  for (std::size_t e = 0; e < centres.size(); ++e) {
    LiftingGroup& group =
        groups_[elem2group_.emplace_back(cell(centres[e].x - low.x) + n * cell(centres[e].y - low.y))];
    group.radius = std::max(group.radius,
                            distance(group.centre, centres[e]) + field::radius_of(evaluator_->maps()[e], centres[e]));
  }
}

// Series are linear in the jumps: each change is added.
void FarLiftings::update(LiftingGroup& group, std::vector<Vec2>& jumps) const {
  const std::vector<Lifting>& liftings = evaluator_->field().liftings;
  jumps.resize(liftings.size());
  group.near_liftings.clear();
  group.bend = group.rounding = group.jumps = 0;
  for (std::size_t i = 0; i < liftings.size(); ++i) {
    const Lifting& lifting = liftings[i];
    if (!is_far(lifting, group.centre, group.radius)) {
      group.near_liftings.push_back(lifting);
      continue;
    }
    const Vec2 change = lifting.jump - std::exchange(jumps[i], lifting.jump);
    const Vec2 to_apex = lifting.apex - group.centre, to_pole = lifting.pole - group.centre;
    for (const auto& [d, sign] : {std::pair(to_apex, 1.0), std::pair(to_pole, -1.0)}) {
      if (change != Vec2{}) add_series(d, sign * change, group);
      const double nearest = norm(d) - group.radius, size = norm(lifting.jump);
      group.bend += size / (nearest * nearest);
      group.rounding += size / nearest;
    }
    group.jumps += norm(lifting.jump);
    if (change != Vec2{}) group.at_centre += field::lifting_angle(lifting, group.centre) * change;
  }
}

void FarLiftings::renew() {
  std::vector<Vec2> jumps = jumps_of(evaluator_->field());
  if (jumps != jumps_) is_current_.assign(groups_.size(), false);
  jumps_ = std::move(jumps);
}

const LiftingGroup& FarLiftings::of(int elem) {
  const int g = elem2group_[elem];
  if (!is_current_[g]) update(groups_[g], group2jumps_[g]);
  is_current_[g] = true;
  return groups_[g];
}

field::FieldSample FarLiftings::sample(int elem, Vec2 xi) {
  const Field& field = evaluator_->field();
  const LiftingGroup& group = of(elem);
  field::FieldSample s;
  evaluator_->maps()[elem].evaluate(xi, s.x, s.dx_dxi);
  const int offset = field.coef_offsets[elem];
  Mat2 dv_dxi;
  s.value = spectral::orthogonal_sum(field.elem_order[elem], &field.u[offset], &field.v[offset], xi, dv_dxi);
  s.dv_dx = dv_dxi * inverse(s.dx_dxi);
  if (group.jumps > 0) s.value += group.far_sum(s.x, s.dv_dx);
  for (const Lifting& lifting : group.near_liftings) {
    if (s.x == lifting.apex) continue;
    const Vec2 g = field::lifting_gradient(lifting, s.x), jump = lifting.jump;
    s.value += field::lifting_angle(lifting, s.x) * jump;
    s.dv_dx = {s.dv_dx.xx + jump.x * g.x, s.dv_dx.xy + jump.x * g.y, s.dv_dx.yx + jump.y * g.x,
               s.dv_dx.yy + jump.y * g.y};
  }
  return s;
}

}  // namespace quadrille::zeros
