#include "field/evaluate.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "curve/pole_box.hpp"
#include "field/explicit_value.hpp"
#include "mesh/tri_topology.hpp"
#include "spectral/orthogonal_basis.hpp"

namespace quadrille::field {
namespace {

constexpr double margin = 1.1;  // for the bulge of curved edges, and stages of steps that leave the element

// With fewer terms, groups of elements save nothing.
constexpr int least_terms_for_groups = 128;
constexpr int elements_per_group = 64;
constexpr int cells_across_group = 3;

}  // namespace

double radius_of(const spectral::TriMap& map, Vec2 centre) {
  double radius = 0;
  for (const Vec2 xi : {Vec2{-1, -1}, Vec2{1, -1}, Vec2{-1, 1}, Vec2{0, -1}, Vec2{0, 0}, Vec2{-1, 0}})
    radius = std::max(radius, distance(centre, map.position(xi)));
  return margin * radius;
}

DiscTerms::DiscTerms(const Field& field)
    : is_phase_(field.kind == FieldKind::phase),
      expansion_({}, 0),
      at_centre_(is_phase_ ? Vec2{1, 0} : Vec2{}),
      near_liftings_(field.liftings),
      near_terms_(field.phase.terms) {}

DiscTerms::DiscTerms(const DiscTerms& outer, Vec2 centre, double radius)
    : is_phase_(outer.is_phase_), expansion_(outer.expansion_.inside(centre, radius)) {
  if (is_phase_)
    split_terms(outer, centre);
  else
    split_liftings(outer, centre);
}

int DiscTerms::num_near() const {
  const PhaseTerms& terms = near_terms_;
  return static_cast<int>(near_liftings_.size() + terms.nodes.size() + terms.holes.size() + terms.images.size() +
                          terms.corner_angles.size());
}

// The principal value of theta_c jumps across the segment from the apex to the pole: it is the continuous sum of the
// expansion only if no point of that segment is near.
void DiscTerms::split_liftings(const DiscTerms& outer, Vec2 centre) {
  at_centre_ = outer.far_liftings(centre);
  for (const Lifting& lifting : outer.near_liftings_)
    if (expansion_.is_far(lifting.apex, lifting.pole)) {
      expansion_.add(lifting.apex, lifting.jump);
      expansion_.add(lifting.pole, -lifting.jump);
      at_centre_ += lifting.jump * lifting_angle(lifting, centre);
    } else {
      near_liftings_.push_back(lifting);
    }
}

void DiscTerms::split_turns(const std::vector<PhaseTurn>& turns, std::vector<PhaseTurn>& near,
                            std::vector<PhaseTurn>& far) {
  for (const PhaseTurn& turn : turns) {
    if (turn.turns == 0) continue;
    const bool is_far = expansion_.is_far(turn.position, turn.position);
    (is_far ? far : near).push_back(turn);
    if (is_far) expansion_.add(turn.position, {static_cast<double>(turn.turns), 0});
  }
}

void DiscTerms::split_terms(const DiscTerms& outer, Vec2 centre) {
  const PhaseTerms& terms = outer.near_terms_;
  PhaseTerms far;
  split_turns(terms.nodes, near_terms_.nodes, far.nodes);
  split_turns(terms.holes, near_terms_.holes, far.holes);
  split_turns(terms.images, near_terms_.images, far.images);
  for (const CornerAngle& corner : terms.corner_angles)
    if (expansion_.is_far(corner.apex, corner.pole)) {
      expansion_.add(corner.apex, {corner.beta, 0});
      expansion_.add(corner.pole, {-corner.beta, 0});
      far.corner_angles.push_back(corner);
    } else {
      near_terms_.corner_angles.push_back(corner);
    }
  at_centre_ = product(outer.at_centre_, explicit_direction(far, centre, centre, outer.far_phase(centre)));
}

template <typename Outer>
const DiscTerms& ElementTerms::Disc::made(const Outer& outer) {
  if (const DiscTerms* made = ready.load(std::memory_order_acquire)) return *made;
  std::call_once(is_made, [&] {
    terms = std::make_unique<const DiscTerms>(outer(), centre, radius);
    ready.store(terms.get(), std::memory_order_release);
  });
  return *terms;
}

void ElementTerms::Disc::enclose(const Disc& other) {
  radius = std::max(radius, distance(centre, other.centre) + other.radius);
}

ElementTerms::ElementTerms(const Field& field, const std::vector<spectral::TriMap>& maps)
    : all_(field), discs_(maps.size()) {
  for (std::size_t e = 0; e < maps.size(); ++e) {
    discs_[e].centre = maps[e].position(centroid);
    discs_[e].radius = radius_of(maps[e], discs_[e].centre);
  }
  if (all_.num_near() >= least_terms_for_groups) group_elements();
}

// The cells are those of a grid over the centroids, the groups squares of cells.
void ElementTerms::group_elements() {
  curve::PoleBox box{discs_.front().centre, discs_.front().centre};
  for (const Disc& disc : discs_) box.extend({disc.centre, disc.centre});
  const auto& [low, high] = box;
  const int num_groups = 1 + static_cast<int>(std::sqrt(static_cast<double>(discs_.size()) / elements_per_group));
  const int n = cells_across_group * num_groups;
  const double side = std::max(high.x - low.x, high.y - low.y) / n;
  const auto cell = [&](double offset) { return side > 0 ? std::min(static_cast<int>(offset / side), n - 1) : 0; };
  cells_ = std::vector<Disc>(static_cast<std::size_t>(n) * n);
  groups_ = std::vector<Disc>(static_cast<std::size_t>(num_groups) * num_groups);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int group_i = i / cells_across_group, group_j = j / cells_across_group;
      cell2group_.push_back(group_i + num_groups * group_j);
      cells_[i + n * j].centre = low + side * Vec2{i + 0.5, j + 0.5};
      groups_[cell2group_.back()].centre = low + cells_across_group * side * Vec2{group_i + 0.5, group_j + 0.5};
    }
  for (const Disc& disc : discs_) {
    elem2cell_.push_back(cell(disc.centre.x - low.x) + n * cell(disc.centre.y - low.y));
    cells_[elem2cell_.back()].enclose(disc);
  }
  for (std::size_t c = 0; c < cells_.size(); ++c)
    if (cells_[c].radius > 0) groups_[cell2group_[c]].enclose(cells_[c]);
}

const DiscTerms& ElementTerms::of(int elem) const {
  if (groups_.empty()) return discs_[elem].made([this]() -> const DiscTerms& { return all_; });
  const auto of_group = [&]() -> const DiscTerms& {
    return groups_[cell2group_[elem2cell_[elem]]].made([this]() -> const DiscTerms& { return all_; });
  };
  return discs_[elem].made([&]() -> const DiscTerms& { return cells_[elem2cell_[elem]].made(of_group); });
}

FieldEvaluator::FieldEvaluator(const Field& field, FarTerms far_terms)
    : field_(&field),
      is_phase_(field.kind == FieldKind::phase),
      maps_(mesh::tri_maps(field.mesh)),
      topology_(mesh::tri_topology(field.mesh)),
      locator_(field.mesh, maps_) {
  set_far_terms(far_terms);
}

void FieldEvaluator::set_far_terms(FarTerms far_terms) {
  expanded_ = far_terms == FarTerms::expanded ? std::make_unique<const ElementTerms>(*field_, maps_) : nullptr;
}

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
