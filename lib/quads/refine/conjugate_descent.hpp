#pragma once
// The direction in which relaxation moves all vertices at once: preconditioned conjugate gradients (Polak-Ribiere, with
// a restart if the direction does not descend) for the shape energy.
//
// The preconditioner is the inverse of the Hessian's diagonal blocks, one for each vertex. On the boundary gradient and
// block are reduced to the curve's tangent. No vertex moves by more than a quarter of the shortest edge at it.

#include "refine/relax_problem.hpp"

namespace quadrille::refine {

class ConjugateDescent {
 public:
  /// `problem` must outlive it.
  explicit ConjugateDescent(const RelaxProblem& problem) : problem_(&problem) {}

  /// The direction at these nodes, which result from `moves`, conjugate to the one before. 0 for fixed vertices.
  VertexMoves next(const std::vector<Vec2>& nodes, const VertexMoves& moves);

 private:
  const RelaxProblem* problem_;
  VertexMoves last_gradient_, last_direction_;
  double last_slope_ = 0;  ///< of the energy along the descent of the last call; < 0 after the first
};

}  // namespace quadrille::refine
