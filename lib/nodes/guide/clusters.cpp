#include "guide/clusters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/tolerance.hpp"
#include "guide/zeros_in_circle.hpp"
#include "surface/positions.hpp"
#include "zeros/undecided_zeros.hpp"
#include "zeros/winding.hpp"

namespace quadrille::guide {
namespace {

/// A zero, or a set of open cells that touch.
struct Part {
  Vec2 centre;
  double radius = 0;
  int elem = 0;
  int zero = -1;  ///< index into the zeros; -1: open cells
};

/// A circle around discs; its centre is the middle of their bounding box.
template <typename Discs>
zeros::Disc circle_about(const Discs& discs) {
  Vec2 lower{HUGE_VAL, HUGE_VAL}, upper{-HUGE_VAL, -HUGE_VAL};
  for (const auto& d : discs) {
    lower = {std::min(lower.x, d.centre.x - d.radius), std::min(lower.y, d.centre.y - d.radius)};
    upper = {std::max(upper.x, d.centre.x + d.radius), std::max(upper.y, d.centre.y + d.radius)};
  }
  zeros::Disc circle{0.5 * (lower + upper), 0};
  for (const auto& d : discs) circle.radius = std::max(circle.radius, distance(circle.centre, d.centre) + d.radius);
  return circle;
}

std::vector<Part> parts_of(const std::vector<zeros::FoundZero>& zeros, const std::vector<zeros::OpenCell>& open_cells) {
  std::vector<Part> parts;
  for (std::size_t i = 0; i < zeros.size(); ++i) parts.push_back({zeros[i].x, 0, zeros[i].elem, static_cast<int>(i)});
  const int num_open = static_cast<int>(open_cells.size());
  DisjointSets touching(open_cells.size());
  for (int i = 0; i < num_open; ++i)
    for (int j = 0; j < i; ++j)
      if (distance(open_cells[i].centre, open_cells[j].centre) <= 2 * (open_cells[i].radius + open_cells[j].radius))
        touching.unite(i, j);
  for (const std::vector<int>& group : touching.sets()) {
    std::vector<zeros::Disc> discs;
    for (const int i : group) discs.push_back({open_cells[i].centre, open_cells[i].radius});
    const zeros::Disc circle = circle_about(discs);
    parts.push_back({circle.centre, circle.radius, open_cells[group[0]].elem, -1});
  }
  return parts;
}

Vec2 nearest(const std::vector<Vec2>& points, Vec2 x) {
  return *std::min_element(points.begin(), points.end(),
                           [x](Vec2 a, Vec2 b) { return distance(a, x) < distance(b, x); });
}

class ClusterFinder {
 public:
  ClusterFinder(const field::FieldEvaluator& evaluator, const std::vector<zeros::FoundZero>& zeros,
                const std::vector<zeros::OpenCell>& open_cells, const ClusterCriterion& criterion)
      : evaluator_(&evaluator),
        zeros_(&zeros),
        criterion_(criterion),
        boundary_(evaluator.field().mesh.face),
        diameter_(evaluator.field().mesh.face.diameter),
        parts_(parts_of(zeros, open_cells)) {}

  Clustering find() const {
    const int num_parts = static_cast<int>(parts_.size());
    DisjointSets together(parts_.size());
    for (int i = 0; i < num_parts; ++i)
      for (int j = 0; j < i; ++j)
        if (belong_together(parts_[i], parts_[j])) together.unite(i, j);
    const std::vector<int> opposite = unite_opposite(together);
    const std::vector<int> undecided = unite_undecided(together);
    Clustering result;
    for (const std::vector<int>& group : together.sets()) {
      const bool has_zero = std::any_of(group.begin(), group.end(), [this](int i) { return parts_[i].zero >= 0; });
      if (group.size() == 1 && has_zero) {
        result.simple.push_back((*zeros_)[parts_[group[0]].zero]);
        continue;
      }
      Cluster found = cluster(group);
      if (!has_zero && found.index == 0) continue;
      found.is_undecided = contains_one_of(group, undecided);
      found.is_far_from_boundary = contains_one_of(group, opposite) && !found.is_undecided;
      result.clusters.push_back(std::move(found));
    }
    return result;
  }

 private:
  static bool contains_one_of(const std::vector<int>& group, const std::vector<int>& parts) {
    return std::find_first_of(group.begin(), group.end(), parts.begin(), parts.end()) != group.end();
  }

  /// Criterion (d). Returns a zero of each group.
  std::vector<int> unite_opposite(DisjointSets& together) const {
    std::vector<int> result;
    if (criterion_.distance == 0) return result;
    for (const std::vector<int>& group : opposite_zeros(*evaluator_, boundary_, *zeros_)) {
      for (const int i : group) together.unite(group[0], i);
      result.push_back(group[0]);
    }
    return result;
  }

  /// Criterion (c). Returns a zero of each group that was not united before.
  std::vector<int> unite_undecided(DisjointSets& together) const {
    std::vector<int> result;
    const double error = zeros::undecided_below(evaluator_->field());
    for (const std::vector<int>& group : zeros::undecided_zeros(*evaluator_, *zeros_, error)) {
      const bool is_known =
          std::all_of(group.begin(), group.end(), [&](int i) { return together.find(i) == together.find(group[0]); });
      if (is_known) continue;
      for (const int i : group) together.unite(group[0], i);
      result.push_back(group[0]);
    }
    return result;
  }

  double error(int elem) const {
    const std::vector<double>& errors = evaluator_->field().elem_error;
    return errors.empty() ? 0 : errors[elem];
  }

  /// Criterion (a) without the condition on the distance.
  bool stays_small(const Part& a, const Part& b) const {
    const double small = std::max(10 * criterion_.noise, 1.5 * std::max(error(a.elem), error(b.elem)));
    for (const double part : {0.25, 0.5, 0.75}) {
      Vec2 value;
      if (!evaluator_->value_at(a.centre + part * (b.centre - a.centre), value) || norm(value) > small) return false;
    }
    return true;
  }

  bool belong_together(const Part& a, const Part& b) const {
    const double gap = distance(a.centre, b.centre) - a.radius - b.radius;
    if (gap <= std::max(a.radius, b.radius)) return true;
    if (gap <= criterion_.distance * (1 + tolerance::tied) && boundary_.is_visible(a.centre, b.centre)) return true;
    return gap <= 0.05 * diameter_ && stays_small(a, b);
  }

  /// The greatest admissible radius of a circle about `centre`: nine tenths of the distance to the nearest part that is
  /// not in `group`, at most half the diameter.
  double outer_radius(const std::vector<int>& group, Vec2 centre) const {
    double reach = diameter_ / 2;
    for (int i = 0; i < static_cast<int>(parts_.size()); ++i)
      if (!std::binary_search(group.begin(), group.end(), i))
        reach = std::min(reach, 0.9 * (distance(parts_[i].centre, centre) - parts_[i].radius));
    return reach;
  }

  /// Evaluated on the smallest circle about the cluster on which |v| exceeds its errors, or, if |v| does so on no
  /// circle, on the circle with the greatest least |v|; the radii grow by a quarter.
  int index_by_contour(const std::vector<int>& group, const zeros::Disc& circle) const {
    const double outer = outer_radius(group, circle.centre);
    const double enough = std::max(10 * criterion_.noise, 4 * error(parts_[group[0]].elem));
    double best = 0;
    std::optional<int> result;
    for (double radius = std::max(1.25 * circle.radius, tolerance::round_off * diameter_); radius <= outer;
         radius *= 1.25) {
      double least = 0;
      const std::optional<int> index = zeros::circle_index(*evaluator_, circle.centre, radius, least);
      if (!index) break;
      if (least > best) best = least, result = index;
      if (least > enough) break;
    }
    if (result) return *result;
    throw ComputeError(
        fmt::format("the guiding field vanishes to higher order near {}, within {:.2g}: its index is not known",
                    surface::position_text(evaluator_->field().mesh.face, circle.centre), circle.radius));
  }

  Cluster cluster(const std::vector<int>& group) const {
    std::vector<Part> parts;
    for (const int i : group) parts.push_back(parts_[i]);
    const zeros::Disc circle = circle_about(parts);
    Cluster result;
    const bool are_distinct = std::all_of(parts.begin(), parts.end(), [](const Part& p) { return p.zero >= 0; });
    for (const Part& part : parts) {
      result.members.push_back(part.centre);
      result.centre += part.centre / static_cast<double>(parts.size());
      if (!are_distinct) continue;
      result.member_indices.push_back((*zeros_)[part.zero].index);
      result.index += result.member_indices.back();
    }
    if (!are_distinct) {
      result.index = index_by_contour(group, circle);
      result.centre = circle.centre;
    }
    if (evaluator_->locator().find(result.centre).elem < 0) result.centre = nearest(result.members, result.centre);
    if (std::abs(result.index) >= 2) {
      const double inner = std::max(2 * circle.radius, tolerance::same_point * diameter_),
                   outer = outer_radius(group, circle.centre);
      result.centre = moment_centre(*evaluator_, circle.centre, result.index, inner, outer).value_or(result.centre);
    }
    for (const Part& part : parts)
      result.radius = std::max(result.radius, distance(result.centre, part.centre) + part.radius);
    return result;
  }

  const field::FieldEvaluator* evaluator_;
  const std::vector<zeros::FoundZero>* zeros_;
  ClusterCriterion criterion_;
  curve::FaceBoundary boundary_;
  double diameter_;
  std::vector<Part> parts_;
};

}  // namespace

Clustering find_clusters(const field::FieldEvaluator& evaluator, const std::vector<zeros::FoundZero>& zeros,
                         const std::vector<zeros::OpenCell>& open_cells, const ClusterCriterion& criterion) {
  return ClusterFinder(evaluator, zeros, open_cells, criterion).find();
}

}  // namespace quadrille::guide
