#pragma once
// The inverse of the Hessian of an energy of moves, by a sparse factorisation: elements that are much thinner than
// others need no more steps than equal ones.

#include <Eigen/Sparse>

#include "refine/size_energy.hpp"

namespace quadrille::refine {

class FactoredHessian {
 public:
  /// `problem` must outlive it.
  explicit FactoredHessian(const RelaxProblem& problem) : problem_(problem) {}

  /// `hessians`: by element, positive semidefinite, those of elements without free vertices not read. O(n^1.5) for n
  /// vertices.
  void set(const std::vector<ElementHessian>& hessians, const SizeEnergy& energy);
  /// The inverse times a gradient; 0 for fixed vertices. O(n log n).
  VertexMoves operator()(const VertexMoves& gradient) const;

 private:
  const RelaxProblem& problem_;
  bool has_pattern_ = false;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors_;
};

}  // namespace quadrille::refine
