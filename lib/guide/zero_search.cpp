#include "guide/zero_search.hpp"

#include <algorithm>
#include <utility>

#include "guide/cell_zero.hpp"

namespace quadrille {
namespace {

constexpr int max_depth = 72;           // 2^-36 of an element's size
constexpr long long max_cells = 50000;  // in one element; a simple zero needs some hundred at most

}  // namespace

ZeroSearch::ZeroSearch(const FieldEvaluator& evaluator, std::vector<Disc> ignored)
    : evaluator_(&evaluator), ignored_(std::move(ignored)), halves_(max_depth) {}

void ZeroSearch::search(int elem) {
  budget_ = max_cells;
  visit(element_cell(*evaluator_, elem), 0);
}

bool ZeroSearch::is_ignored() const {
  return std::any_of(ignored_.begin(), ignored_.end(), [this](const Disc& disc) {
    return distance(disc.centre, enclosure_.centre()) + enclosure_.radius() <= disc.radius;
  });
}

void ZeroSearch::visit(const Cell& cell, int depth) {
  if (budget_ == 0) return;
  ++counts_.examined;
  counts_.greatest_depth = std::max(counts_.greatest_depth, depth);
  enclosure_.set(cell, evaluator_->field().liftings);
  if (enclosure_.excludes_zero()) {
    ++counts_.excluded;
    return;
  }
  if (is_ignored()) {
    ++counts_.ignored;
    return;
  }
  Mat2 inverse_jacobian;
  double contraction = 0;
  if (enclosure_.isolates(inverse_jacobian, contraction)) {
    ++counts_.isolated;
    Vec2 xi;
    if (find_cell_zero(*evaluator_, cell, inverse_jacobian, contraction, enclosure_.value_noise(), xi))
      zeros_.push_back({cell.elem, xi, evaluator_->maps()[cell.elem].position(xi), enclosure_.radius()});
    return;
  }
  if (--budget_ == 0 || depth == max_depth || enclosure_.greatest_value() < field_noise) {
    open_.push_back({cell.elem, enclosure_.centre(), enclosure_.radius()});
    return;
  }
  auto& [first, second] = halves_[depth];
  bisect(cell, first, second);
  visit(first, depth + 1);
  visit(second, depth + 1);
}

}  // namespace quadrille
