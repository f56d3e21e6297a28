#pragma once
// The inverse of the Hessian of an energy of moves, from the last steps (Nocedal 1980) and a first matrix: that of its
// diagonal blocks (refine/coarse_moves), or its factors (refine/factored_hessian).

#include <deque>

#include "refine/coarse_moves.hpp"
#include "refine/factored_hessian.hpp"

namespace quadrille::refine {

double inner_product(const VertexMoves& a, const VertexMoves& b);
/// Adds factor * other.
void add_multiple(double factor, const VertexMoves& other, VertexMoves& to);

class InverseHessian {
 public:
  /// `problem` must outlive it.
  explicit InverseHessian(const RelaxProblem& problem) : coarse_(problem), factored_(problem) {}

  /// As CoarseMoves has them. Steps so far are not forgotten.
  void set_blocks(const DiagonalBlocks& blocks, const std::vector<Vec2>& tangents);
  /// Of where the energy was computed last. Steps so far are not forgotten.
  void factorise(const SizeEnergy& energy);
  void forget() { pairs_.clear(); }
  bool is_factored() const { return is_factored_; }
  /// Whether it knows no step.
  bool is_plain() const { return pairs_.empty(); }
  /// `change`: of the gradient by the step.
  void add_step(VertexMoves step, VertexMoves change);

  /// The step to the least energy, if its Hessian were this one.
  VertexMoves descent(const VertexMoves& gradient) const;

 private:
  struct Pair {
    VertexMoves step, change;
    double curvature = 0;
  };
  double factor() const;

  VertexMoves first(const VertexMoves& gradient) const {
    return is_factored_ ? factored_(gradient) : coarse_(gradient);
  }

  CoarseMoves coarse_;
  FactoredHessian factored_;
  bool is_factored_ = false;
  std::deque<Pair> pairs_;
};

}  // namespace quadrille::refine
