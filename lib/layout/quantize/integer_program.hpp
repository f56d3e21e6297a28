#pragma once
// Linear programs with integer variables, for the branch-and-cut solver CBC of COIN-OR.

#include <vector>

namespace quadrille::quantize {

/// Minimises cost . x with low <= x <= high and rows of the form sum coefficient x = right side.
class IntegerProgram {
 public:
  struct Term {
    int variable = 0;
    double coefficient = 0;
  };

  int add_variable(double low, double high, double cost, bool is_integer);
  void add_equation(const std::vector<Term>& terms, double right_side);

  /// The values of the variables, integer ones rounded; empty if there is no solution. The search is bounded by a
  /// number of nodes and not by time, so that the result is deterministic; the best solution found is returned.
  std::vector<double> solve() const;

 private:
  std::vector<double> low_, high_, cost_;
  std::vector<bool> is_integer_;
  std::vector<std::vector<Term>> column_;  // row and coefficient, of each variable
  std::vector<double> right_side_;
};

}  // namespace quadrille::quantize
