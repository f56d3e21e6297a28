#pragma once
// The normal equations of a sum of weighted squares of linear residuals: steps of Gauss and Newton.

#include <Eigen/Sparse>
#include <initializer_list>
#include <vector>

namespace quadrille::growth {

class NormalEquations {
 public:
  explicit NormalEquations(int num_unknowns) : right_(Eigen::VectorXd::Zero(num_unknowns)) {}

  /// The derivative of a residual by an unknown; those of number -1 are fixed.
  struct Term {
    int unknown = -1;
    double slope = 0;
  };

  /// Adds weight residual^2, and returns it.
  double add(double weight, double residual, std::initializer_list<Term> terms) {
    for (const Term& a : terms) {
      if (a.unknown < 0) continue;
      right_[a.unknown] -= weight * a.slope * residual;
      for (const Term& b : terms)
        if (b.unknown >= 0) entries_.emplace_back(a.unknown, b.unknown, weight * a.slope * b.slope);
    }
    return weight * residual * residual;
  }

  Eigen::SparseMatrix<double> matrix() const {
    Eigen::SparseMatrix<double> matrix(right_.size(), right_.size());
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    return matrix;
  }
  const Eigen::VectorXd& right() const { return right_; }
  /// The step that minimises the sum. Cost: a sparse factorisation.
  Eigen::VectorXd step() const { return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix()).solve(right_); }

 private:
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::VectorXd right_;
};

}  // namespace quadrille::growth
