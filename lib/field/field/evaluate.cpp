#include "field/evaluate.hpp"

#include <cmath>

#include "base/error.hpp"
#include "field/explicit_value.hpp"
#include "mesh/tri_maps.hpp"
#include "spectral/orthogonal_basis.hpp"

namespace quadrille::field {

FieldEvaluator::FieldEvaluator(const Field& field, FarTerms far_terms)
    : field_(&field),
      is_phase_(field.kind == FieldKind::phase),
      maps_(mesh::tri_maps(field.mesh)),
      topology_(mesh::tri_topology(field.mesh)),
      locator_(field.mesh, maps_),
      expanded_(far_terms == FarTerms::expanded ? std::make_unique<const ElementTerms>(field, maps_) : nullptr) {}

Vec2 FieldEvaluator::inward(int elem, Vec2 x) const { return normalized(maps_[elem].position(centroid) - x); }

const DiscTerms* FieldEvaluator::expanded_terms(int elem, Vec2 x) const {
  if (!expanded_) return nullptr;
  const DiscTerms& terms = expanded_->of(elem);
  return terms.contains(x) ? &terms : nullptr;
}

Vec2 FieldEvaluator::sum_of(const std::vector<Lifting>& liftings, int elem, Vec2 x) const {
  Vec2 sum;
  for (const Lifting& lifting : liftings) {
    const bool at_apex = x == lifting.apex;
    sum += lifting.jump * (at_apex ? lifting_angle_at_apex(lifting, inward(elem, x)) : lifting_angle(lifting, x));
  }
  return sum;
}

Vec2 FieldEvaluator::liftings(int elem, Vec2 x) const {
  if (field_->liftings.empty()) return {};
  const DiscTerms* terms = expanded_terms(elem, x);
  return terms ? terms->far_liftings(x) + sum_of(terms->near_liftings(), elem, x) : sum_of(field_->liftings, elem, x);
}

Vec2 FieldEvaluator::phase_value(double remainder, int elem, Vec2 x) const {
  const DiscTerms* terms = expanded_terms(elem, x);
  const PhaseTerms& near = terms ? terms->near_terms() : field_->phase.terms;
  const Vec2 towards = near.corner_angles.empty() ? x : maps_[elem].position(centroid);  // asked for at corners only
  if (!terms) return product(unit(remainder), explicit_direction(near, x, towards));
  return product(terms->far_direction(), explicit_direction(near, x, towards, remainder + terms->far_phase(x)));
}

Vec2 FieldEvaluator::value(int elem, Vec2 xi, Vec2& x, Mat2& dx_dxi) const {
  maps_[elem].evaluate(xi, x, dx_dxi);
  const int offset = field_->coef_offsets[elem];
  if (is_phase_) {
    const double* s = &field_->phase.s[offset];
    return phase_value(spectral::orthogonal_sum(field_->elem_order[elem], s, s, xi).x, elem, x);
  }
  return spectral::orthogonal_sum(field_->elem_order[elem], &field_->u[offset], &field_->v[offset], xi) +
         liftings(elem, x);
}

Vec2 FieldEvaluator::value(mesh::Location at) const {
  Vec2 x;
  Mat2 dx_dxi;
  return value(at.elem, at.xi, x, dx_dxi);
}

// d e^(i phi) = i e^(i phi) d phi.
FieldSample FieldEvaluator::phase_sample(int elem, Vec2 xi) const {
  const RemainderSample s =
      remainder_sample(maps_[elem], field_->elem_order[elem], &field_->phase.s[field_->coef_offsets[elem]], xi);
  const Vec2 value = phase_value(s.value, elem, s.x), across = left_of(value);
  const Vec2 slope = s.slope + explicit_phase_gradient(field_->phase.terms, s.x);
  return {s.x, s.dx_dxi, value, {across.x * slope.x, across.x * slope.y, across.y * slope.x, across.y * slope.y}};
}

FieldSample FieldEvaluator::sample(int elem, Vec2 xi) const {
  if (is_phase_) return phase_sample(elem, xi);
  FieldSample s;
  maps_[elem].evaluate(xi, s.x, s.dx_dxi);
  const int offset = field_->coef_offsets[elem];
  Mat2 dv_dxi;
  s.value = spectral::orthogonal_sum(field_->elem_order[elem], &field_->u[offset], &field_->v[offset], xi, dv_dxi) +
            liftings(elem, s.x);
  s.dv_dx = dv_dxi * inverse(s.dx_dxi);
  for (const Lifting& lifting : field_->liftings) {
    if (s.x == lifting.apex) continue;  // the gradient has no limit there
    const Vec2 g = lifting_gradient(lifting, s.x);
    s.dv_dx.xx += lifting.jump.x * g.x;
    s.dv_dx.xy += lifting.jump.x * g.y;
    s.dv_dx.yx += lifting.jump.y * g.x;
    s.dv_dx.yy += lifting.jump.y * g.y;
  }
  return s;
}

bool FieldEvaluator::value_at(Vec2 x, Vec2& value_there) const {
  mesh::Location at;
  return value_near(x, at, value_there);
}

bool FieldEvaluator::value_near(Vec2 x, mesh::Location& at, Vec2& value_there) const {
  mesh::Location found = at;
  if (found.elem < 0 || !maps_[found.elem].invert(x, found.xi) || mesh::outside_reference(found.xi) > 0)
    found = locator_.find(x);
  if (found.elem < 0) return false;
  at = found;
  value_there = value(at);
  return true;
}

std::vector<PointSample> FieldEvaluator::values_at(const std::vector<Vec2>& points) const {
  std::vector<PointSample> result;
  result.reserve(points.size());
  mesh::Location last;
  for (const Vec2 x : points) {
    mesh::Location at = mesh::walk(topology_, maps_, x, last);
    if (at.elem < 0) at = locator_.find(x);
    PointSample& here = result.emplace_back();
    here.at = at;
    if (at.elem < 0) continue;
    here.value = value(at);
    last = at;
  }
  return result;
}

// The value is that of a cross: it turns four times as far.
std::vector<PointSample> FieldsOfRegions::values_in(std::size_t region, std::vector<Vec2> points) const {
  const curve::Rotation& rotation = rotations_[region];
  if (rotation.angle == 0) return regions_[region]->values_at(points);
  for (Vec2& x : points) x = rotation.inverse().of(x);
  std::vector<PointSample> samples = regions_[region]->values_at(points);
  for (PointSample& sample : samples) sample.value = curve::Rotation{{}, 4 * rotation.angle}.of_vector(sample.value);
  return samples;
}

std::vector<PointSample> FieldsOfRegions::values_at(const std::vector<Vec2>& points) const {
  std::vector<PointSample> samples = values_in(0, points);
  for (std::size_t r = 1; r < regions_.size(); ++r) {
    std::vector<std::size_t> numbers;
    std::vector<Vec2> rest;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (samples[i].at.elem < 0) numbers.push_back(i), rest.push_back(points[i]);
    if (rest.empty()) break;
    const std::vector<PointSample> found = values_in(r, rest);
    for (std::size_t k = 0; k < rest.size(); ++k) samples[numbers[k]] = found[k];
  }
  return samples;
}

double node_phase(const FieldEvaluator& evaluator, int node) {
  const Field& field = evaluator.field();
  PhaseTerms others = field.phase.terms;
  const Vec2 x = others.nodes.at(node).position;
  others.nodes[node].turns = 0;
  const mesh::Location at = evaluator.locator().find(x);
  if (at.elem < 0) throw FormatError("an irregular node lies outside the field's mesh");
  const double* s = &field.phase.s[field.coef_offsets[at.elem]];
  return spectral::orthogonal_sum(field.elem_order[at.elem], s, s, at.xi).x + explicit_phase(others, x);
}

}  // namespace quadrille::field
