#include "spectral/jacobi.hpp"

namespace quadrille::spectral {

JacobiStep jacobi_step(int n, double alpha, double beta) {
  // The general formula is 0/0 at n = 0 when alpha + beta is 0 or -1.
  if (n == 0) return {(alpha + beta + 2) / 2, (alpha - beta) / 2, 0};
  const double s = 2 * n + alpha + beta;
  const double scale = 2 * (n + 1) * (n + alpha + beta + 1) * s;
  return {s * (s + 1) * (s + 2) / scale, (s + 1) * (alpha * alpha - beta * beta) / scale,
          2 * (n + alpha) * (n + beta) * (s + 2) / scale};
}

double jacobi(int n, double alpha, double beta, double x) {
  double previous = 0, value = 1;
  for (int k = 0; k < n; ++k) {
    const JacobiStep step = jacobi_step(k, alpha, beta);
    const double next = (step.a * x + step.b) * value - step.c * previous;
    previous = value;
    value = next;
  }
  return value;
}

double jacobi_derivative(int n, double alpha, double beta, double x) {
  if (n == 0) return 0;
  return (n + alpha + beta + 1) / 2 * jacobi(n - 1, alpha + 1, beta + 1, x);
}

}  // namespace quadrille::spectral
