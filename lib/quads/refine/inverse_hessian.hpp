#pragma once
// The inverse of the Hessian of an energy of moves, from its diagonal blocks (refine/coarse_moves) and the last steps
// (Nocedal 1980).

#include <deque>

#include "refine/coarse_moves.hpp"

namespace quadrille::refine {

double inner_product(const VertexMoves& a, const VertexMoves& b);
/// Adds factor * other.
void add_multiple(double factor, const VertexMoves& other, VertexMoves& to);

class InverseHessian {
 public:
  /// `problem` must outlive it.
  explicit InverseHessian(const RelaxProblem& problem) : first_(problem) {}

  /// As CoarseMoves has them. Steps so far are not forgotten.
  void set_blocks(const DiagonalBlocks& blocks, const std::vector<Vec2>& tangents);
  void forget() { pairs_.clear(), factor_ = 1; }
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
  void set_factor();

  CoarseMoves first_;  ///< but for a factor
  double factor_ = 1;
  std::deque<Pair> pairs_;
};

}  // namespace quadrille::refine
