#include "refine/inverse_hessian.hpp"

#include <cmath>
#include <utility>

namespace quadrille::refine {
namespace {

constexpr int memory = 12;                 ///< steps that are known
constexpr double least_curvature = 1e-10;  ///< of a step, of that of a change along it

}  // namespace

double inner_product(const VertexMoves& a, const VertexMoves& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += dot(a[i], b[i]);
  return sum;
}

void add_multiple(double factor, const VertexMoves& other, VertexMoves& to) {
  for (std::size_t i = 0; i < to.size(); ++i) to[i] += factor * other[i];
}

void InverseHessian::set_blocks(const DiagonalBlocks& blocks, const std::vector<Vec2>& tangents) {
  coarse_.set_blocks(blocks, tangents);
  is_factored_ = false;
}

void InverseHessian::factorise(const SizeEnergy& energy) {
  factored_.set(energy.hessians(), energy);
  is_factored_ = true;
}

/// Of the first matrix: so that the last step follows from its change.
double InverseHessian::factor() const {
  if (pairs_.empty()) return 1;
  const Pair& last = pairs_.back();
  return last.curvature / inner_product(last.change, first(last.change));
}

void InverseHessian::add_step(VertexMoves step, VertexMoves change) {
  const double curvature = inner_product(step, change);
  if (!(curvature > least_curvature * std::sqrt(inner_product(step, step) * inner_product(change, change)))) return;
  pairs_.push_back({std::move(step), std::move(change), curvature});
  if (static_cast<int>(pairs_.size()) > memory) pairs_.pop_front();
}

VertexMoves InverseHessian::descent(const VertexMoves& gradient) const {
  VertexMoves d = gradient;
  std::vector<double> parts;
  for (auto pair = pairs_.rbegin(); pair != pairs_.rend(); ++pair) {
    parts.push_back(inner_product(pair->step, d) / pair->curvature);
    add_multiple(-parts.back(), pair->change, d);
  }
  d = first(d);
  const double by = factor();
  for (Vec2& x : d) x *= by;
  for (const Pair& pair : pairs_) {
    add_multiple(parts.back() - inner_product(pair.change, d) / pair.curvature, pair.step, d);
    parts.pop_back();
  }
  for (Vec2& x : d) x = -x;
  return d;
}

}  // namespace quadrille::refine
