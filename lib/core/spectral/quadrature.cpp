#include "spectral/quadrature.hpp"

#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "spectral/per_order.hpp"

namespace quadrille::spectral {

JacobiStep jacobi_step(int n, double alpha, double beta) {
  // The general formula is 0/0 at n = 0 when alpha + beta is 0 or -1.
  if (n == 0) return {(alpha + beta + 2) / 2, (alpha - beta) / 2, 0};
  const double s = 2 * n + alpha + beta;
  const double scale = 2 * (n + 1) * (n + alpha + beta + 1) * s;
  return {s * (s + 1) * (s + 2) / scale, (s + 1) * (alpha * alpha - beta * beta) / scale,
          2 * (n + alpha) * (n + beta) * (s + 2) / scale};
}

double jacobi(int n, double alpha, double beta, double x) { return JacobiPolynomials(n, alpha, beta).last(x); }

double jacobi_derivative(int n, double alpha, double beta, double x) {
  if (n == 0) return 0;
  return (n + alpha + beta + 1) / 2 * jacobi(n - 1, alpha + 1, beta + 1, x);
}

namespace {

// Zeros of P_n^{(alpha, beta)}, from Chebyshev points, by Newton's method with the known zeros divided out.
std::vector<double> jacobi_zeros(int n, double alpha, double beta) {
  const JacobiPolynomials polynomials(n, alpha, beta), slopes(n - 1, alpha + 1, beta + 1);
  const auto slope = [&](double x) { return (n + alpha + beta + 1) / 2 * slopes.last(x); };
  std::vector<double> zeros(n);
  for (int k = 0; k < n; ++k) {
    double x = -std::cos((2 * k + 1) * std::numbers::pi / (2 * n));
    if (k > 0) x = (x + zeros[k - 1]) / 2;
    for (int iteration = 0; iteration < 50; ++iteration) {
      double poles = 0;
      for (int i = 0; i < k; ++i) poles += 1 / (x - zeros[i]);
      const double value = polynomials.last(x);
      const double step = -value / (slope(x) - poles * value);
      x += step;
      if (std::abs(step) < 1e-16) break;
    }
    // One step on the polynomial itself, because the deflated one has lost a few digits.
    zeros[k] = x - polynomials.last(x) / slope(x);
  }
  return zeros;
}

// Makes a symmetric rule exactly symmetric in spite of rounding.
void symmetrize(Quadrature& rule) {
  const std::size_t n = rule.points.size();
  for (std::size_t i = 0, j = n - 1; i < j; ++i, --j) {
    rule.points[j] = (rule.points[j] - rule.points[i]) / 2;
    rule.points[i] = -rule.points[j];
    rule.weights[i] = rule.weights[j] = (rule.weights[i] + rule.weights[j]) / 2;
  }
  if (n % 2 == 1) rule.points[n / 2] = 0;
}

// The weights are known in closed form up to a factor, which follows from their sum.
void scale_weights(Quadrature& rule, double sum) {
  double total = 0;
  for (const double w : rule.weights) total += w;
  for (double& w : rule.weights) w *= sum / total;
}

Quadrature make_lobatto(int n) {
  Quadrature rule{{-1}, {}};
  const std::vector<double> inner = jacobi_zeros(n - 2, 1, 1);
  rule.points.insert(rule.points.end(), inner.begin(), inner.end());
  rule.points.push_back(1);
  for (const double x : rule.points) {
    const double p = jacobi(n - 1, 0, 0, x);
    rule.weights.push_back(1 / (p * p));
  }
  symmetrize(rule);
  scale_weights(rule, 2);
  return rule;
}

std::vector<double> make_gll_points(int order) { return gauss_lobatto(order + 1).points; }

}  // namespace

Quadrature gauss_jacobi(int n, double alpha, double beta) {
  if (n < 1) throw Defect("a Gauss rule needs at least one point");
  Quadrature rule{jacobi_zeros(n, alpha, beta), {}};
  for (const double x : rule.points) {
    const double slope = jacobi_derivative(n, alpha, beta, x);
    rule.weights.push_back(1 / ((1 - x * x) * slope * slope));
  }
  if (alpha == beta) symmetrize(rule);
  const double sum =
      std::pow(2, alpha + beta + 1) * std::tgamma(alpha + 1) * std::tgamma(beta + 1) / std::tgamma(alpha + beta + 2);
  scale_weights(rule, sum);
  return rule;
}

Quadrature gauss_lobatto(int n) {
  if (n < 2) throw Defect("a Gauss-Lobatto rule needs at least two points");
  return make_lobatto(n);
}

const std::vector<double>& gll_points(int order) {
  static PerOrder<std::vector<double>> tables(make_gll_points);
  return tables[order];
}

}  // namespace quadrille::spectral
