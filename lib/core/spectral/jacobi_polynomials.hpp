#pragma once
// Jacobi polynomials at many points: the steps of their recurrence are made once.

#include <utility>
#include <vector>

#include "spectral/quadrature.hpp"

namespace quadrille::spectral {

/// P_0 .. P_n^{(alpha, beta)}; P_0 alone if n < 0.
class JacobiPolynomials {
 public:
  JacobiPolynomials(int n, double alpha, double beta) {
    for (int k = 0; k < n; ++k) steps_.push_back(jacobi_step(k, alpha, beta));
  }
  /// P_n(x).
  double last(double x) const {
    double before = 0, value = 1;
    for (const JacobiStep& step : steps_) advance(step, x, before, value);
    return value;
  }
  /// P_0(x) .. P_n(x).
  std::vector<double> all(double x) const {
    double before = 0, value = 1;
    std::vector<double> values{value};
    for (const JacobiStep& step : steps_) {
      advance(step, x, before, value);
      values.push_back(value);
    }
    return values;
  }

 private:
  static void advance(const JacobiStep& step, double x, double& before, double& value) {
    before = std::exchange(value, (step.a * x + step.b) * value - step.c * before);
  }

  std::vector<JacobiStep> steps_;
};

}  // namespace quadrille::spectral
