#include "field/element_terms.hpp"

#include <algorithm>
#include <cmath>

#include "curve/pole_box.hpp"
#include "field/explicit_value.hpp"

namespace quadrille::field {
namespace {

constexpr double margin = 1.1;  // for the bulge of curved edges, and stages of steps that leave the element

// With fewer terms, groups of elements save nothing.
constexpr int least_terms_for_groups = 128;
constexpr int elements_per_group = 64;
constexpr int cells_across_group = 3;

// The radius of a disc around the centroid that contains the element.
double radius_of(const spectral::TriMap& map, Vec2 centre) {
  double radius = 0;
  for (const Vec2 xi : {Vec2{-1, -1}, Vec2{1, -1}, Vec2{-1, 1}, Vec2{0, -1}, Vec2{0, 0}, Vec2{-1, 0}})
    radius = std::max(radius, distance(centre, map.position(xi)));
  return margin * radius;
}

}  // namespace

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

}  // namespace quadrille::field
