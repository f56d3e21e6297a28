#pragma once
// Jacobi polynomials P_n^{(alpha, beta)} on [-1, 1] by their three-term recurrence, and quadrature rules for any number
// of points, by Newton's method to round-off (Karniadakis and Sherwin, app. A and B).

#include <utility>
#include <vector>

namespace quadrille::spectral {

/// P_{n+1}(x) = (a x + b) P_n(x) - c P_{n-1}(x), n >= 0 (c = 0 for n = 0).
struct JacobiStep {
  double a = 0, b = 0, c = 0;
};

JacobiStep jacobi_step(int n, double alpha, double beta);

/// P_0 .. P_n^{(alpha, beta)}, P_0 alone if n < 0, for many points: the steps of the recurrence are made once.
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

/// P_n^{(alpha, beta)}(x), n >= 0, alpha, beta > -1. Linear in n.
double jacobi(int n, double alpha, double beta, double x);

/// Its derivative: (n + alpha + beta + 1) / 2 times P_{n-1}^{(alpha+1, beta+1)}(x).
double jacobi_derivative(int n, double alpha, double beta, double x);

struct Quadrature {
  std::vector<double> points;   ///< ascending in [-1, 1]
  std::vector<double> weights;  ///< same length
};

/// n-point Gauss-Jacobi rule for the weight (1-x)^alpha (1+x)^beta: exact to degree 2n - 1.
Quadrature gauss_jacobi(int n, double alpha, double beta);
inline Quadrature gauss_legendre(int n) { return gauss_jacobi(n, 0, 0); }

/// n-point Gauss-Lobatto-Legendre rule (n >= 2), ends included: exact to degree 2n - 3.
Quadrature gauss_lobatto(int n);

/// The N + 1 Gauss-Lobatto-Legendre points of an edge of order N >= 1, ascending.
const std::vector<double>& gll_points(int order);

}  // namespace quadrille::spectral
