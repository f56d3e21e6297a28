#include "zeros/zero_search.hpp"

#include <algorithm>
#include <utility>

#include "zeros/cell_zero.hpp"

namespace quadrille::zeros {
namespace {

constexpr int max_depth = 72;           // 2^-36 of an element's size
constexpr long long max_cells = 50000;  // in one element; a simple zero needs some hundred at most

std::array<Vec2, 3> vertices(const Cell& cell) { return {cell.vertex(0), cell.vertex(1), cell.vertex(2)}; }

bool touches_vertex(const Cell& cell, int k) {
  const Vec2 vertex = k == 0 ? Vec2{-1, -1} : k == 1 ? Vec2{1, -1} : Vec2{-1, 1};
  return std::find(cell.xi.begin(), cell.xi.end(), vertex) != cell.xi.end();
}

}  // namespace

ZeroSearch::ZeroSearch(const field::FieldEvaluator& evaluator, std::vector<Disc> ignored, double noise)
    : evaluator_(&evaluator),
      ignored_(std::move(ignored)),
      noise_(noise),
      jumps_(edge_jumps(evaluator)),
      halves_(max_depth) {}

void ZeroSearch::search(int elem) {
  budget_ = max_cells;
  visit(element_cell(*evaluator_, elem), 0);
}

void ZeroSearch::skip() {
  ++found_.counts.examined;
  ++found_.counts.excluded;
}

bool ZeroSearch::is_ignored() const {
  return std::any_of(ignored_.begin(), ignored_.end(), [this](const Disc& disc) {
    return distance(disc.centre, enclosure_.centre()) + enclosure_.radius() <= disc.radius;
  });
}

double ZeroSearch::margin(const Cell& cell) const {
  double greatest = 0;
  if (jumps_.empty()) return greatest;
  for (int k = 0; k < 3; ++k) {
    if (touches_edge(cell, k)) greatest = std::max(greatest, jumps_[cell.elem].edge[k]);
    if (touches_vertex(cell, k)) greatest = std::max(greatest, jumps_[cell.elem].vertex[k]);
  }
  return greatest;
}

void ZeroSearch::isolate(const Cell& cell, const Mat2& inverse_jacobian, double contraction) {
  ++found_.counts.isolated;
  const double noise = enclosure_.value_noise();
  Vec2 xi;
  if (!find_cell_zero(*evaluator_, cell, inverse_jacobian, contraction, noise, xi)) return;
  const field::FieldSample s = evaluator_->sample(cell.elem, xi);
  const double shift = noise * frobenius_norm(s.dv_dx) / std::abs(det(s.dv_dx));  // |J^-1| noise
  found_.zeros.push_back({cell.elem, xi, s.x, det(s.dv_dx) > 0 ? 1 : -1, enclosure_.radius(), shift, vertices(cell)});
}

void ZeroSearch::visit(const Cell& cell, int depth) {
  if (budget_ == 0) return;
  ++found_.counts.examined;
  found_.counts.greatest_depth = std::max(found_.counts.greatest_depth, depth);
  const double jump = margin(cell);
  enclosure_.set(cell, evaluator_->field().liftings, jump);
  if (enclosure_.excludes_zero()) {
    ++found_.counts.excluded;
    return;
  }
  if (is_ignored()) {
    ++found_.counts.ignored;
    return;
  }
  Mat2 inverse_jacobian;
  double contraction = 0;
  if (enclosure_.isolates(inverse_jacobian, contraction)) return isolate(cell, inverse_jacobian, contraction);
  if (--budget_ == 0 || depth == max_depth || enclosure_.greatest_value() < std::max(noise_, jump)) {
    found_.open_cells.push_back({cell.elem, enclosure_.centre(), enclosure_.radius(), vertices(cell)});
    return;
  }
  auto& [first, second] = halves_[depth];
  bisect(cell, first, second);
  visit(first, depth + 1);
  visit(second, depth + 1);
}

}  // namespace quadrille::zeros
