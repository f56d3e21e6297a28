#pragma once
// Jacobi polynomials P_n^{(alpha, beta)} on [-1, 1] by their three-term recurrence (Karniadakis and Sherwin, app. A).

namespace quadrille::spectral {

/// P_{n+1}(x) = (a x + b) P_n(x) - c P_{n-1}(x), n >= 0 (c = 0 for n = 0).
struct JacobiStep {
  double a = 0, b = 0, c = 0;
};

JacobiStep jacobi_step(int n, double alpha, double beta);

/// P_n^{(alpha, beta)}(x), n >= 0, alpha, beta > -1. Linear in n.
double jacobi(int n, double alpha, double beta, double x);

/// Its derivative: (n + alpha + beta + 1) / 2 times P_{n-1}^{(alpha+1, beta+1)}(x).
double jacobi_derivative(int n, double alpha, double beta, double x);

}  // namespace quadrille::spectral
